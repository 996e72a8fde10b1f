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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::lineOfSight::lineOfSight(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, lineOfSight>(mesh),
    halfLongest_(0)
{
    const solvedDirections plane(mesh);

    // Both ends of each, and of its mirror image beyond an axis
    DynamicList<vector> mine;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled() || !solvedDirections::cutsPlane(pp))
        {
            continue;
        }
        for (const face& f : pp)
        {
            const Pair<vector2> ends(plane.ends(mesh.points(), f));
            mine.append(plane.toPoint(ends.first()));
            mine.append(plane.toPoint(ends.second()));
            if (plane.axisymmetric())
            {
                mine.append(plane.toPoint(plane.mirrored(ends.first())));
                mine.append(plane.toPoint(plane.mirrored(ends.second())));
            }
        }
    }
    List<List<vector>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    allGatherList(all);

    DynamicList<obstacle> faces;
    DynamicList<point> middles;
    for (const List<vector>& ends : all)
    {
        for (label i = 0; i < ends.size(); i += 2)
        {
            faces.append(obstacle(plane(ends[i]), plane(ends[i + 1])));
            middles.append(0.5*(ends[i] + ends[i + 1]));
            halfLongest_ = max(halfLongest_, 0.5*mag(ends[i + 1] - ends[i]));
        }
    }
    faces_.transfer(faces);
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
    const vector2& move,
    DynamicList<obstacle>& obstacles
) const
{
    treeBoundBox around(box);
    around.min() -= vector::uniform(halfLongest_);
    around.max() += vector::uniform(halfLongest_);

    labelList found(tree_->findBox(around));
    Foam::sort(found);
    for (const label i : found)
    {
        obstacles.append
        (
            obstacle(faces_[i].first() + move, faces_[i].second() + move)
        );
    }
}


bool Foam::capsule::lineOfSight::clear
(
    const UList<obstacle>& obstacles,
    const vector2& a,
    const vector2& b
)
{
    // Through the common end of two faces there is no way: to round-off ends
    // count
    const vector2 d = b - a;
    for (const obstacle& o : obstacles)
    {
        const vector2 n = turned(o.second() - o.first());
        const vector2 c = turned(d);
        const scalar round = 1e-9*n.norm();

        const scalar atA = (a - o.first()).dot(n);
        const scalar atB = (b - o.first()).dot(n);
        const scalar atFirst = (o.first() - a).dot(c);
        const scalar atSecond = (o.second() - a).dot(c);
        if
        (
            min(atA, atB) < round*n.norm()
         && max(atA, atB) > -round*n.norm()
         && min(atFirst, atSecond) < round*d.norm()
         && max(atFirst, atSecond) > -round*d.norm()
        )
        {
            return false;
        }
    }
    return true;
}
