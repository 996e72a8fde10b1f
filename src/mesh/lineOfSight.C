/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "lineOfSight.H"
#include "releases.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(lineOfSight, 0);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

// Through the common end of two segments, or edge of two triangles, there is no
// way: to round-off ends and edges count

//- Does the line from a to b meet a segment in the plane?
static bool meetsSegment
(
    const lineOfSight::obstacle& o,
    const vector2& a,
    const vector2& b
)
{
    const vector2 first = o.row(0);
    const vector2 second = o.row(1);
    const vector2 d = b - a;
    const vector2 n = turned(second - first);
    const vector2 c = turned(d);
    const scalar round = 1e-9*n.norm();

    const scalar atA = (a - first).dot(n);
    const scalar atB = (b - first).dot(n);
    const scalar atFirst = (first - a).dot(c);
    const scalar atSecond = (second - a).dot(c);
    return
        min(atA, atB) < round*n.norm()
     && max(atA, atB) > -round*n.norm()
     && min(atFirst, atSecond) < round*d.norm()
     && max(atFirst, atSecond) > -round*d.norm();
}


//- Does the line from a to b meet a triangle in space?
static bool meetsTriangle
(
    const lineOfSight::obstacle& o,
    const vector& a,
    const vector& b
)
{
    // Corners and ends from the first corner
    const vector origin(o(0, 0), o(0, 1), o(0, 2));
    const vector p(vector(o(1, 0), o(1, 1), o(1, 2)) - origin);
    const vector q(vector(o(2, 0), o(2, 1), o(2, 2)) - origin);
    const vector from(a - origin);
    const vector to(b - origin);
    const vector d(to - from);
    const scalar round = 1e-9*(mag(p) + mag(q));

    // Apart along an axis, that is: in a projection
    const auto apart = [&](const vector& axis)
    {
        const scalar atA = from & axis;
        const scalar atB = to & axis;
        const scalar atP = p & axis;
        const scalar atQ = q & axis;
        const scalar gap = round*mag(axis);
        return
            min(atA, atB) > max(max(atP, atQ), scalar(0)) + gap
         || max(atA, atB) < min(min(atP, atQ), scalar(0)) - gap;
    };

    const vector n(p ^ q);
    if (apart(n))
    {
        return false;
    }
    for (const vector& edge : {p, q, vector(q - p)})
    {
        // The second axis is for a line in the plane of the triangle
        if (apart(edge ^ d) || apart(edge ^ n))
        {
            return false;
        }
    }
    return !apart(n ^ d);
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::lineOfSight::appendCorners
(
    const fvMesh& mesh,
    const solvedDirections& directions,
    const face& f,
    DynamicList<vector>& corners
)
{
    if (directions.spatial())
    {
        faceList triangles(f.nTriangles());
        label n = 0;
        f.triangles(mesh.points(), n, triangles);
        for (const face& triangle : triangles)
        {
            for (const label pointi : triangle)
            {
                corners.append(mesh.points()[pointi]);
            }
        }
        return;
    }

    const auto ends = directions.ends(mesh.points(), f);
    corners.append(directions.toPoint(ends.first()));
    corners.append(directions.toPoint(ends.second()));
    if (directions.axisymmetric())
    {
        corners.append
        (
            directions.toPoint(directions.mirrored(ends.first()))
        );
        corners.append
        (
            directions.toPoint(directions.mirrored(ends.second()))
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::lineOfSight::lineOfSight(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, lineOfSight>(mesh),
    largest_(0)
{
    const solvedDirections directions(mesh);

    DynamicList<vector> mine;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled() && solvedDirections::cutsPlane(pp))
        {
            for (const face& f : pp)
            {
                appendCorners(mesh, directions, f, mine);
            }
        }
    }
    List<List<vector>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    allGatherList(all);

    const label n = (directions.spatial() ? 3 : 2);
    DynamicList<obstacle> obstacles;
    DynamicList<point> middles;
    for (const List<vector>& corners : all)
    {
        for (label i = 0; i < corners.size(); i += n)
        {
            const SubList<vector> here(corners, n, i);
            const point middle(sum(here)/n);
            obstacle o(n, n);
            for (label j = 0; j < n; ++j)
            {
                o.row(j) = directions(here[j]);
                largest_ = max(largest_, mag(here[j] - middle));
            }
            obstacles.append(o);
            middles.append(middle);
        }
    }
    obstacles_.transfer(obstacles);
    middles_.transfer(middles);

    treeBoundBox bounds(mesh.bounds());
    bounds.add(middles_);
    bounds.inflate(0.01);
    tree_.reset
    (
        new indexedOctree<treeDataPoint>
        (
            treeDataPoint(middles_), bounds, 12, 10, 3
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::lineOfSight::append
(
    const boundBox& box,
    const solvedVector& move,
    DynamicList<obstacle>& obstacles
) const
{
    treeBoundBox around(box);
    around.min() -= vector::uniform(largest_);
    around.max() += vector::uniform(largest_);

    labelList found(tree_->findBox(around));
    Foam::sort(found);
    for (const label i : found)
    {
        obstacles.append(obstacle(obstacles_[i].rowwise() + move));
    }
}


Foam::List<Foam::capsule::lineOfSight::obstacle>
Foam::capsule::lineOfSight::near
(
    const UList<obstacle>& obstacles,
    const solvedVector& x,
    const scalar radius
)
{
    DynamicList<obstacle> result;
    for (const obstacle& o : obstacles)
    {
        const scalar length =
            (o.rowwise() - o.row(0)).rowwise().norm().maxCoeff();
        if ((o.row(0) - x).norm() < radius + length)
        {
            result.append(o);
        }
    }
    return List<obstacle>(std::move(result));
}


bool Foam::capsule::lineOfSight::clear
(
    const UList<obstacle>& obstacles,
    const solvedVector& a,
    const solvedVector& b
)
{
    if (obstacles.empty())
    {
        return true;
    }
    if (a.size() == 2)
    {
        const vector2 from = a;
        const vector2 to = b;
        for (const obstacle& o : obstacles)
        {
            if (meetsSegment(o, from, to))
            {
                return false;
            }
        }
        return true;
    }

    const vector from(a(0), a(1), a(2));
    const vector to(b(0), b(1), b(2));
    for (const obstacle& o : obstacles)
    {
        if (meetsTriangle(o, from, to))
        {
            return false;
        }
    }
    return true;
}
