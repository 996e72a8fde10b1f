/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "clearance.H"
#include "cellSearch.H"
#include "volFields.H"

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

//- Points of a smooth closed curve and one between each two of them, by the
//  four-point scheme (Dyn, Levin and Gregory 1987)
static nodalVectors subdivided(const nodalVectors& x)
{
    const label n = x.rows();
    nodalVectors result(2*n, 2);
    for (label i = 0; i < n; ++i)
    {
        const label j = (i + 1) % n;
        result.row(2*i) = x.row(i);
        result.row(2*i + 1) =
            (
                9*(x.row(i) + x.row(j))
              - x.row((i + n - 1) % n) - x.row((i + 2) % n)
            )/16;
    }
    return result;
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
    const solvedDirections& plane
)
:
    plane_(plane),
    boundary_(meshBoundary::New(mesh)),
    width_(gMin(plane.widths(mesh)())),
    largest_(cellSearch::New(mesh).largestWidth())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::capsule::clearance::obstacle
(
    const nodalVectors& curve,
    const scalar cells
) const
{
    for (const vector2& p : plane_.images().periods())
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

    const string near = boundary_.nearest(subdivided(subdivided(curve)), cells);
    if (near.empty() && !boundary_.contains(curve.row(0)))
    {
        // It crosses none: the whole curve lies outside
        return "the boundary";
    }
    return near;
}


bool Foam::capsule::clearance::meet
(
    const nodalVectors& a,
    const nodalVectors& b,
    const scalar cells
) const
{
    if (plane_.images().periods().empty())
    {
        return meetHere(a, b, cells);
    }
    const vector2 centre = middle(b);
    for (const vector2& image : plane_.images().images(centre, middle(a)))
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
    const closedSurface& curve,
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
