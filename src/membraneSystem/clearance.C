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
static solvedVector middle(const nodalVectors& points)
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


//- Those of given points that are in a box with a margin around it
static nodalVectors inBox
(
    const nodalVectors& points,
    const solvedVector& low,
    const solvedVector& high,
    const scalar margin
)
{
    nodalVectors result(points.rows(), points.cols());
    label n = 0;
    for (label i = 0; i < points.rows(); ++i)
    {
        const solvedVector x = points.row(i);
        if (min((x - low).minCoeff(), (high - x).minCoeff()) >= -margin)
        {
            result.row(n++) = x;
        }
    }
    return result.topRows(n);
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::capsule::solvedVector> Foam::capsule::clearance::moves
(
    const surfaceSamples& of,
    const surfaceSamples& near
) const
{
    const solvedVector centre = middle(of.points());
    List<solvedVector> result(1, solvedVector(0*centre));
    if (!directions_.images().periods().empty())
    {
        result = directions_.images().images(centre, middle(near.points()));
        for (solvedVector& image : result)
        {
            image -= centre;
        }
    }
    return result;
}


bool Foam::capsule::clearance::close
(
    const surfaceSamples& a,
    const surfaceSamples& b,
    const solvedVector& move,
    const scalar cells
) const
{
    const nodalVectors moved = b.points().rowwise() + move;
    const scalar margin = cells*width_;
    const solvedVector lowA = a.points().colwise().minCoeff();
    const solvedVector highA = a.points().colwise().maxCoeff();
    const solvedVector lowB = moved.colwise().minCoeff();
    const solvedVector highB = moved.colwise().maxCoeff();

    // Boxes apart, as those of most images are
    if (max((lowA - highB).maxCoeff(), (lowB - highA).maxCoeff()) > margin)
    {
        return false;
    }

    const nodalVectors nearB = inBox(a.points(), lowB, highB, margin);
    const nodalVectors nearA = inBox(moved, lowA, highA, margin);
    for (label i = 0; nearA.rows() && i < nearB.rows(); ++i)
    {
        const scalar nearest =
            (nearA.rowwise() - nearB.row(i)).rowwise().squaredNorm().minCoeff();
        if (nearest < sqr(margin))
        {
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::clearance::clearance
(
    const fvMesh& mesh,
    const solvedDirections& directions
)
:
    directions_(directions),
    boundary_(meshBoundary::New(mesh)),
    width_(gMin(directions.widths(mesh)())),
    largest_(cellSearch::New(mesh).largestWidth())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::capsule::clearance::obstacle
(
    const nodalVectors& points,
    const scalar cells
) const
{
    for (const solvedVector& p : directions_.images().periods())
    {
        const nodalScalars along = points*p.transpose()/p.norm();
        const scalar gap = p.norm() - (along.maxCoeff() - along.minCoeff());
        if (gap < leastToImage*largest_)
        {
            return
                "its periodic image (there "
              + Foam::name(leastToImage) + " cell widths)";
        }
    }

    const string near = boundary_.nearest
    (
        directions_.spatial() ? points : subdivided(subdivided(points)), cells
    );
    if (near.empty() && !boundary_.contains(points.row(0)))
    {
        // It crosses none: the whole surface lies outside
        return "the boundary";
    }
    return near;
}


bool Foam::capsule::clearance::meet
(
    const surfaceSamples& a,
    const surfaceSamples& b,
    const scalar cells,
    const bool nested
) const
{
    for (const solvedVector& move : moves(b, a))
    {
        if (close(a, b, move, cells))
        {
            return true;
        }
    }
    return nested != (inside(a, b) || inside(b, a));
}


bool Foam::capsule::clearance::inside
(
    const surfaceSamples& inner,
    const surfaceSamples& outer
) const
{
    const solvedVector low = outer.points().colwise().minCoeff();
    const solvedVector high = outer.points().colwise().maxCoeff();
    for (const solvedVector& move : moves(inner, outer))
    {
        const solvedVector x = inner.points().row(0) + move;
        if
        (
            min((x - low).minCoeff(), (high - x).minCoeff()) >= 0
         && outer.contains(x)
        )
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::capsule::clearance::film
(
    const closedSurface& surface,
    solvedVector& where
) const
{
    const nodalVectors& x = surface.nodes();
    const nodalVectors& normal = surface.normal();

    scalar least = sqr(resolved*width_);
    for (label i = 0; i < x.rows(); ++i)
    {
        for (label j = i + 1; j < x.rows(); ++j)
        {
            const solvedVector d = x.row(j) - x.row(i);
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


Foam::scalar Foam::capsule::clearance::spacing
(
    const closedSurface& surface
) const
{
    if (surface.spatial())
    {
        return
            Foam::sqrt
            (
                surface.basis().weights().cwiseProduct
                (
                    surface.areaElement()
                ).maxCoeff()
            )/width_;
    }
    const nodalVectors& x = surface.nodes();
    const label n = x.rows();
    nodalVectors sides(n, 2);
    sides.topRows(n - 1) = x.bottomRows(n - 1) - x.topRows(n - 1);
    sides.row(n - 1) = x.row(0) - x.row(n - 1);
    return sides.rowwise().norm().maxCoeff()/width_;
}
