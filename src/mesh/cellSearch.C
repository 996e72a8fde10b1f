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

static pointField middles(const fvMesh& mesh, const solvedDirections& plane)
{
    pointField result(mesh.nCells());
    forAll(result, celli)
    {
        result[celli] = plane.toPoint(plane(mesh.cellCentres()[celli]));
    }
    return result;
}


//- Size of a cell along the normal of its longest face, and across
static cellSearch::size sizeOf
(
    const fvMesh& mesh,
    const solvedDirections& plane,
    const label celli
)
{
    cellSearch::size result{vector2(1, 0), vector2(0, 0)};
    scalar longest = 0;
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
        const Pair<vector2> ends
        (
            plane.ends(mesh.points(), mesh.faces()[facei])
        );
        const scalar length = (ends.second() - ends.first()).norm();
        if (length > (1 + 1e-6)*longest)
        {
            longest = length;
            result.direction = plane(mesh.faceAreas()[facei]).normalized();
        }
    }

    vector2 low = vector2::Constant(GREAT);
    vector2 high = -low;
    for (const label facei : mesh.cells()[celli])
    {
        for (const label pointi : mesh.faces()[facei])
        {
            const vector2 x = result.components
            (
                plane(mesh.points()[pointi] - mesh.cellCentres()[celli])
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
    const solvedDirections plane(mesh);
    forAll(sizes_, celli)
    {
        sizes_[celli] = sizeOf(mesh, plane, celli);
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
    labelList cells(tree_->findBox(treeBoundBox(box)));
    Foam::sort(cells);
    return cells;
}
