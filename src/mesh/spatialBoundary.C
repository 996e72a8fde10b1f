/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "spatialBoundary.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::spatialBoundary::encloses(const solvedVector& x) const
{
    return mesh_.findCell(directions_.toPoint(x)) >= 0;
}


void Foam::capsule::spatialBoundary::nearestHere
(
    const nodalVectors& points,
    nodalScalars& square,
    nodalVectors& feet
) const
{
    const pointField x(directions_.toPoints(points));
    const scalar reach = Foam::sqrt(square.maxCoeff());
    const autoPtr<pointTree> tree(treeOf(x, boundBox(x, false)));
    for (const image& wall : near(x, reach))
    {
        if (!isA<wallPolyPatch>(mesh_.boundaryMesh()[patch(wall)]))
        {
            continue;
        }
        const face& f = mesh_.faces()[walls_[wall.wall]];
        const labelList found
        (
            tree->findSphere
            (
                centres_[wall.wall] + wall.move,
                sqr(reach + radii_[wall.wall])
            )
        );
        for (const label i : found)
        {
            const pointHit hit =
                f.nearestPoint(x[i] - wall.move, mesh_.points());
            if (sqr(hit.distance()) < square(i))
            {
                square(i) = sqr(hit.distance());
                feet.row(i) = directions_(hit.rawPoint() + wall.move);
            }
        }
    }
}


Foam::autoPtr<Foam::capsule::spatialBoundary::pointTree>
Foam::capsule::spatialBoundary::treeOf
(
    const pointField& points,
    const boundBox& box
)
{
    treeBoundBox bounds(box);
    bounds.inflate(0.01);
    return autoPtr<pointTree>
    (
        new pointTree(treeDataPoint(points), bounds, 10, 10, 3)
    );
}


Foam::DynamicList<Foam::capsule::spatialBoundary::image>
Foam::capsule::spatialBoundary::near
(
    const pointField& points,
    const scalar reach
) const
{
    const periodicImages& periodic = directions_.images();
    const boundBox box(points, false);
    const solvedVector centre(directions_(box.midpoint()));

    const List<solvedVector> centres
    (
        periodic.images(centre, periodic.wrapped(centre))
    );

    DynamicList<image> result;
    for (const solvedVector& x : centres)
    {
        const vector move(directions_.toVector(centre - x));
        treeBoundBox around(box);
        around.min() -= move + vector::uniform(reach + largest_);
        around.max() -= move - vector::uniform(reach + largest_);
        labelList found(tree_->findBox(around));
        Foam::sort(found);
        for (const label i : found)
        {
            result.append(image{i, move});
        }
    }
    return result;
}


Foam::scalar Foam::capsule::spatialBoundary::squaredDistance
(
    const image& face,
    const pointField& points,
    const pointTree& tree,
    const scalar bound
) const
{
    const scalar reach = Foam::sqrt(bound) + radii_[face.wall];
    const Foam::face& f = mesh_.faces()[walls_[face.wall]];
    scalar least = bound;
    const labelList found
    (
        tree.findSphere(centres_[face.wall] + face.move, sqr(reach))
    );
    for (const label i : found)
    {
        const scalar distance =
            f.nearestPoint(points[i] - face.move, mesh_.points()).distance();
        least = min(least, sqr(distance));
    }
    return least;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::spatialBoundary::spatialBoundary(const fvMesh& mesh)
:
    meshBoundary(mesh),
    largest_(0),
    widest_(0)
{
    DynamicList<label> walls;
    DynamicList<point> centres;
    DynamicList<scalar> radii;
    DynamicList<scalar> widths;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled())
        {
            continue;
        }
        forAll(pp, i)
        {
            const point& c = pp.faceCentres()[i];
            scalar radius = 0;
            for (const label pointi : pp[i])
            {
                radius = max(radius, mag(mesh.points()[pointi] - c));
            }
            walls.append(pp.start() + i);
            centres.append(c);
            radii.append(radius);
            widths.append
            (
                mesh.cellVolumes()[pp.faceCells()[i]]/mag(pp.faceAreas()[i])
            );
            largest_ = max(largest_, radius);
            widest_ = max(widest_, widths.last());
        }
    }
    walls_.transfer(walls);
    centres_.transfer(centres);
    radii_.transfer(radii);
    widths_.transfer(widths);
    tree_ = treeOf(centres_, mesh.bounds());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::capsule::spatialBoundary::nearest
(
    const nodalVectors& points,
    const scalar cells
) const
{
    const pointField x(directions_.toPoints(points));
    const autoPtr<pointTree> tree(treeOf(x, boundBox(x, false)));

    scalar least = sqr(cells);
    label patchi = -1;
    for (const image& face : near(x, cells*widest_))
    {
        const scalar unit = sqr(widths_[face.wall]);
        const scalar bound = least*unit;
        const scalar square = squaredDistance(face, x, *tree, bound);
        if (square < bound)
        {
            least = square/unit;
            patchi = patch(face);
        }
    }

    const scalar found = returnReduce(least, minOp<scalar>());
    return patchName(least == found ? patchi : -1);
}


Foam::scalar Foam::capsule::spatialBoundary::toWalls
(
    const nodalVectors& points
) const
{
    const pointField x(directions_.toPoints(points));
    const autoPtr<pointTree> tree(treeOf(x, boundBox(x, false)));
    const solvedVector centre = middle(points);

    scalar least = GREAT;
    forAll(walls_, i)
    {
        const solvedVector c(directions_(centres_[i]));
        const image face
        {
            i, directions_.toVector(directions_.images().image(c, centre) - c)
        };
        if (isA<wallPolyPatch>(mesh_.boundaryMesh()[patch(face)]))
        {
            least = squaredDistance(face, x, *tree, least);
        }
    }
    return leastRoot(least);
}


Foam::word Foam::capsule::spatialBoundary::enclosed
(
    const surfaceSamples& surface
) const
{
    const pointField x(directions_.toPoints(surface.points()));
    const boundBox box(x, false);
    label patchi = -1;
    for (const image& face : near(x, 0))
    {
        for (const label pointi : mesh_.faces()[walls_[face.wall]])
        {
            const point corner(mesh_.points()[pointi] + face.move);
            if (box.contains(corner) && surface.contains(directions_(corner)))
            {
                patchi = max(patchi, patch(face));
            }
        }
    }
    return patchName(patchi);
}
