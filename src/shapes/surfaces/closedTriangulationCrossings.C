/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "closedTriangulation.H"
#include "ListOps.H"
#include "boundBox.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Distances of this part of the extent are none
static const scalar touching = 1e-9;

//- Is a point of the plane of a triangle in it?
static bool inTriangle(const point& x, const triPointRef& t, const vector& n)
{
    const scalar slack = -touching*magSqr(n);
    return
        (((t.b() - t.a()) ^ (x - t.a())) & n) >= slack
     && (((t.c() - t.b()) ^ (x - t.b())) & n) >= slack
     && (((t.a() - t.c()) ^ (x - t.c())) & n) >= slack;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::closedTriangulation::meets
(
    const edge& e,
    const triFace& t
) const
{
    const triPointRef triangle(t.tri(points_));
    const vector n = triangle.areaNormal();
    const point& a = points_[e.start()];
    const point& b = points_[e.end()];
    const scalar ha = (a - triangle.a()) & n;
    const scalar hb = (b - triangle.a()) & n;
    const scalar slack = touching*extent_*mag(n);
    if ((ha > slack && hb > slack) || (ha < -slack && hb < -slack))
    {
        return false;
    }
    if (mag(ha) <= slack && mag(hb) <= slack)
    {
        // In the plane of the triangle
        return
            inTriangle(a, triangle, n)
         || inTriangle(b, triangle, n)
         || inTriangle(0.5*(a + b), triangle, n);
    }
    const scalar w = min(max(ha/(ha - hb), scalar(0)), scalar(1));
    return inTriangle(a + w*(b - a), triangle, n);
}


void Foam::capsule::closedTriangulation::checkFolds() const
{
    forAll(edges_, i)
    {
        const vector n =
            triangles_[atEdge_[i][0]].areaNormal(points_);
        const vector m =
            triangles_[atEdge_[i][1]].areaNormal(points_);
        const scalar square = sqr(edges_[i].mag(points_));
        if
        (
            min(mag(n), mag(m)) > 1e-6*square
         && (n & m) < -(1 - 1e-6)*mag(n)*mag(m)
        )
        {
            refusal()
                << "the surface turns back on itself at the edge from "
                << points_[edges_[i].start()] << " to "
                << points_[edges_[i].end()] << exit(FatalIOError);
        }
    }
}


void Foam::capsule::closedTriangulation::checkCrossings() const
{
    // Triangles in the order of their least coordinate along the longest side
    // of the box: those near an edge follow each other
    const vector span = boundBox(points_, false).span();
    const direction d =
        (span.x() >= max(span.y(), span.z()) ? 0 : span.y() > span.z() ? 1 : 2);
    List<boundBox> boxes(triangles_.size());
    scalarField least(triangles_.size());
    scalar widest = 0;
    forAll(triangles_, i)
    {
        boxes[i] = boundBox(points_, triangles_[i], false);
        boxes[i].min() -= touching*extent_*vector::one;
        boxes[i].max() += touching*extent_*vector::one;
        least[i] = boxes[i].min()[d];
        widest = max(widest, boxes[i].span()[d]);
    }
    const labelList order(sortedOrder(least));
    std::sort(least.begin(), least.end());

    for (const edge& e : edges_)
    {
        const boundBox box(points_, e, false);
        for
        (
            label k = std::lower_bound
            (
                least.begin(), least.end(), box.min()[d] - widest
            ) - least.begin();
            k < least.size() && least[k] <= box.max()[d];
            ++k
        )
        {
            const triFace& t = triangles_[order[k]];
            if
            (
                boxes[order[k]].overlaps(box)
             && !t.found(e.start())
             && !t.found(e.end())
             && meets(e, t)
            )
            {
                refusal()
                    << "the surface crosses or touches itself at the edge from "
                    << points_[e.start()] << " to " << points_[e.end()]
                    << exit(FatalIOError);
            }
        }
    }
}
