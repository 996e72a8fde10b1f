/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cellSearch.H"
#include "solvedDirections.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

static pointField middles
(
    const fvMesh& mesh,
    const solvedDirections& directions
)
{
    pointField result(mesh.nCells());
    forAll(result, celli)
    {
        result[celli] =
            directions.toPoint(directions(mesh.cellCentres()[celli]));
    }
    return result;
}


//- Directions of the mesh at a cell: the normal of its largest face, in space
//  that of the largest one across, and what is perpendicular
static solvedTensor directionsOf
(
    const fvMesh& mesh,
    const solvedDirections& directions,
    const label celli
)
{
    const label n = directions.size();
    solvedTensor result(solvedTensor::Zero(n, n));

    for (label found = 0; found < n - 1; ++found)
    {
        scalar largest = 0;
        for (const label facei : mesh.cells()[celli])
        {
            if
            (
                !mesh.isInternalFace(facei)
             && !solvedDirections::cutsPlane
                (
                    mesh.boundaryMesh()[mesh.boundaryMesh().whichPatch(facei)]
                )
            )
            {
                continue;
            }
            const nodalVectors corners =
                directions.corners(mesh.points(), mesh.faces()[facei]);
            const scalar extent =
                directions.spatial()
              ? mag(mesh.faceAreas()[facei])
              : (corners.row(1) - corners.row(0)).norm();
            const solvedVector normal =
                directions(mesh.faceAreas()[facei]).normalized();
            const bool across =
                found == 0 || mag(normal.dot(result.row(0))) < 0.5;
            if (across && extent > (1 + 1e-6)*largest)
            {
                largest = extent;
                result.row(found) = normal;
            }
        }
    }

    if (!directions.spatial())
    {
        result.row(1) = turned(result.row(0));
        return result;
    }
    const solvedVector second =
        result.row(1) - result.row(1).dot(result.row(0))*result.row(0);
    result.row(1) = second.normalized();
    const vector third =
        directions.toVector(result.row(0)) ^ directions.toVector(result.row(1));
    result.row(2) = directions(third);
    return result;
}


//- Append the points in a box below a node of their tree, perhaps twice: as the
//  tree's own findBox, which takes twice as long for the table it makes
static void appendInBox
(
    const indexedOctree<treeDataPoint>& tree,
    const pointField& points,
    const label nodei,
    const boundBox& box,
    DynamicList<label>& found
)
{
    typedef indexedOctree<treeDataPoint> octree;
    for (const labelBits index : tree.nodes()[nodei].subNodes_)
    {
        if (octree::isNode(index))
        {
            const label below = octree::getNode(index);
            if (box.overlaps(tree.nodes()[below].bb_))
            {
                appendInBox(tree, points, below, box, found);
            }
        }
        else if (octree::isContent(index))
        {
            for (const label i : tree.contents()[octree::getContent(index)])
            {
                if (box.contains(points[i]))
                {
                    found.append(i);
                }
            }
        }
    }
}


//- Size of a cell along the directions of the mesh
static cellSearch::size sizeOf
(
    const fvMesh& mesh,
    const solvedDirections& directions,
    const label celli
)
{
    cellSearch::size result;
    result.directions = directionsOf(mesh, directions, celli);

    solvedVector low = solvedVector::Constant(directions.size(), GREAT);
    solvedVector high = -low;
    for (const label facei : mesh.cells()[celli])
    {
        for (const label pointi : mesh.faces()[facei])
        {
            const solvedVector x = result.components
            (
                directions(mesh.points()[pointi] - mesh.cellCentres()[celli])
            );
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
    }
    result.widths = high - low;
    return result;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(cellSearch, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::cellSearch::cellSearch(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, cellSearch>(mesh),
    centres_(middles(mesh, solvedDirections(mesh))),
    sizes_(mesh.nCells()),
    largest_(0)
{
    const solvedDirections directions(mesh);
    forAll(sizes_, celli)
    {
        sizes_[celli] = sizeOf(mesh, directions, celli);
        largest_ = max(largest_, sizes_[celli].largest());
    }
    reduce(largest_, maxOp<scalar>());

    syncTools::swapBoundaryCellList(mesh, centres_, beyond_);

    treeBoundBox bounds(mesh.bounds());
    bounds.inflate(0.01);
    tree_.reset
    (
        new indexedOctree<treeDataPoint>
        (
            treeDataPoint(centres_), bounds, 12, 10, 3
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::capsule::cellSearch::inBox(const boundBox& box) const
{
    DynamicList<label> cells;
    if (!tree_->nodes().empty())
    {
        appendInBox(*tree_, centres_, 0, box, cells);
    }
    // Once each: a centre on the side of an octant is in two of them
    Foam::inplaceUniqueSort(cells);
    return labelList(std::move(cells));
}
