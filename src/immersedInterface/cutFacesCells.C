/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cutFaces.H"
#include "releases.H"
#include "hexMatcher.H"
#include "prismMatcher.H"
#include "wedgePolyPatch.H"
#include "HashSet.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::cutFaces::longest = 3;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Is a cell a prism at the axis of a wedge, a hexahedron with one side of no
//  width?
static bool atAxis(const fvMesh& mesh, const label celli)
{
    label nWedge = 0;
    for (const label facei : mesh.cells()[celli])
    {
        if (!mesh.isInternalFace(facei))
        {
            const polyBoundaryMesh& patches = mesh.boundaryMesh();
            if (isA<wedgePolyPatch>(patches[patches.whichPatch(facei)]))
            {
                ++nWedge;
            }
        }
    }
    return nWedge == 2 && prismMatcher().isA(mesh, celli);
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::cutFaces::checkCells() const
{
    const fvMesh& mesh = levelSet_.mesh();
    labelHashSet cut;
    List<string> wrong(Pstream::nProcs());
    string& mine = wrong[Pstream::myProcNo()];
    for (const cutLink& v : links_)
    {
        if (v.cell != -1 && cut.insert(v.cell) && mine.empty())
        {
            const string refused = refusal(mesh, v.cell);
            if (!refused.empty())
            {
                OStringStream message;
                message
                    << "Membrane " << levelSet_.name() << " cuts cell "
                    << v.cell << " at " << mesh.cellCentres()[v.cell]
                    << ", which " << refused.c_str() << nl
                    << "    Cells at a membrane must be orthogonal hexahedra,"
                    << " at most " << longest << " times longer than wide.";
                mine = message.str();
            }
        }
    }

    // On all processors alike, for those who go on from it
    if (returnReduce(!mine.empty(), orOp<bool>()))
    {
        allGatherList(wrong);
        for (const string& message : wrong)
        {
            if (!message.empty())
            {
                FatalErrorInFunction << message.c_str() << exit(FatalError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::capsule::cutFaces::refusal
(
    const fvMesh& mesh,
    const label celli
)
{
    // Its tables take longer to make than to use
    static hexMatcher hexahedron;
    if (!hexahedron.isA(mesh, celli) && !atAxis(mesh, celli))
    {
        return "is not a hexahedron";
    }
    for (const label facei : mesh.cells()[celli])
    {
        if (!mesh.isInternalFace(facei))
        {
            const polyBoundaryMesh& patches = mesh.boundaryMesh();
            if
            (
                !solvedDirections::cutsPlane
                (
                    patches[patches.whichPatch(facei)]
                )
            )
            {
                continue;
            }
        }
        const vector s = normalised(mesh.faceAreas()[facei]);
        const vector d =
            normalised(mesh.faceCentres()[facei] - mesh.cellCentres()[celli]);
        if (mag(s & d) < 1 - 1e-6)
        {
            return "is not orthogonal";
        }
    }
    const scalar ratio = cellSearch::New(mesh).ofCell(celli).ratio();
    if (ratio > longest*(1 + 1e-6))
    {
        return "is " + Foam::name(ratio) + " times longer than wide";
    }
    return string::null;
}


// ************************************************************************* //
