/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "clearance.H"
#include "volFields.H"
#include "emptyPolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::clearance::least = 0.5;
const Foam::scalar Foam::capsule::clearance::resolved = 2;
const Foam::scalar Foam::capsule::clearance::leastToImage = 8;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Middle of the box around points
static vector2 middle(const nodalVectors& points)
{
    return 0.5*(points.colwise().minCoeff() + points.colwise().maxCoeff());
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::clearance::meetHere
(
    const nodalVectors& a,
    const nodalVectors& b,
    const scalar cells
) const
{
    // Boxes apart, as those of most images are
    const vector2 after = a.colwise().minCoeff() - b.colwise().maxCoeff();
    const vector2 before = b.colwise().minCoeff() - a.colwise().maxCoeff();
    if (max(after.maxCoeff(), before.maxCoeff()) > cells*width_)
    {
        return false;
    }
    for (label i = 0; i < a.rows(); ++i)
    {
        const scalar nearest =
            (b.rowwise() - a.row(i)).rowwise().squaredNorm().minCoeff();
        if (nearest < sqr(cells*width_))
        {
            return true;
        }
    }
    return inPolygon(a.row(0), b) || inPolygon(b.row(0), a);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::clearance::clearance
(
    const fvMesh& mesh,
    const meshPlane& plane
)
:
    mesh_(mesh),
    plane_(plane),
    width_(Foam::sqrt(gMin(mesh.V().field())/plane.thickness())),
    largest_(Foam::sqrt(gMax(mesh.V().field())/plane.thickness()))
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled() || isA<emptyPolyPatch>(pp))
        {
            continue;
        }
        forAll(pp, i)
        {
            const vector& S = pp.faceAreas()[i];
            centres_.append(plane(pp.faceCentres()[i]));
            normals_.append(plane(S)/mag(S));
            lengths_.append(mag(S)/plane.thickness());
            patches_.append(pp.index());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::capsule::clearance::obstacle
(
    const nodalVectors& curve,
    const scalar cells
) const
{
    nodalVectors points(curve);
    for (label i = 0; i < points.rows(); ++i)
    {
        points.row(i) = plane_.wrapped(curve.row(i));
        if (!plane_.contains(points.row(i)))
        {
            return "the boundary";
        }
    }

    for (const vector2& p : plane_.periods())
    {
        const nodalScalars along = curve*p.transpose()/p.norm();
        const scalar gap = p.norm() - (along.maxCoeff() - along.minCoeff());
        if (gap < leastToImage*largest_)
        {
            return
                "its periodic image (there "
              + Foam::name(leastToImage) + " cell widths)";
        }
    }

    // Boundary faces near the points: depth of the points below the face
    const vector2 margin(cells*width_, cells*width_);
    const vector2 low = points.colwise().minCoeff() - margin;
    const vector2 high = points.colwise().maxCoeff() + margin;
    scalar nearest = GREAT;
    label patchi = -1;
    forAll(centres_, facei)
    {
        const vector2& c = centres_[facei];
        const scalar reach = lengths_[facei];
        if
        (
            c(0) + reach < low(0) || c(0) - reach > high(0)
         || c(1) + reach < low(1) || c(1) - reach > high(1)
        )
        {
            continue;
        }
        for (label i = 0; i < points.rows(); ++i)
        {
            const vector2 d = points.row(i) - c;
            const scalar depth = -d.dot(normals_[facei]);
            const scalar beside = (d + depth*normals_[facei]).norm();
            if (beside < reach && depth < nearest)
            {
                nearest = depth;
                patchi = patches_[facei];
            }
        }
    }

    const scalar found = returnReduce(nearest, minOp<scalar>());
    if (found < cells*width_)
    {
        patchi = returnReduce
        (
            nearest == found ? patchi : labelMin,
            maxOp<label>()
        );
        return mesh_.boundaryMesh()[patchi].name();
    }
    return string::null;
}


bool Foam::capsule::clearance::meet
(
    const nodalVectors& a,
    const nodalVectors& b,
    const scalar cells
) const
{
    if (plane_.periods().empty())
    {
        return meetHere(a, b, cells);
    }
    const vector2 centre = middle(b);
    for (const vector2& image : plane_.images(centre, middle(a)))
    {
        if (meetHere(a, b.rowwise() + (image - centre), cells))
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::capsule::clearance::film
(
    const closedCurve& curve,
    vector2& where
) const
{
    const nodalVectors& x = curve.nodes();
    const nodalVectors& normal = curve.normal();

    scalar least = sqr(resolved*width_);
    for (label i = 0; i < x.rows(); ++i)
    {
        for (label j = i + 1; j < x.rows(); ++j)
        {
            const vector2 d = x.row(j) - x.row(i);
            const scalar square = d.squaredNorm();
            if
            (
                square < least
             && normal.row(i).dot(normal.row(j)) < -0.5
             && sqr(d.dot(normal.row(i))) > 0.5*square
            )
            {
                least = square;
                where = x.row(i) + 0.5*d;
            }
        }
    }
    return Foam::sqrt(least)/width_;
}


Foam::scalar Foam::capsule::clearance::spacing(const nodalVectors& curve) const
{
    const label n = curve.rows();
    nodalVectors sides(n, 2);
    sides.topRows(n - 1) = curve.bottomRows(n - 1) - curve.topRows(n - 1);
    sides.row(n - 1) = curve.row(0) - curve.row(n - 1);
    return sides.rowwise().norm().maxCoeff()/width_;
}
