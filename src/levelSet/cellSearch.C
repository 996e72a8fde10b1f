/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cellSearch.H"
#include "meshPlane.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

static pointField middles(const fvMesh& mesh, const meshPlane& plane)
{
    pointField result(mesh.nCells());
    forAll(result, celli)
    {
        result[celli] = plane.toPoint(plane(mesh.cellCentres()[celli]));
    }
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
    centres_(middles(mesh, meshPlane(mesh))),
    largest_
    (
        Foam::sqrt(gMax(mesh.cellVolumes())/meshPlane(mesh).thickness())
    )
{
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
