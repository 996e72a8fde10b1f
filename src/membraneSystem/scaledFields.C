/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "scaledFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::scaledFields::scaledFields(const fvMesh& mesh)
:
    scale
    (
        IOobject("viscosityScale", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    ),
    sources(mesh),
    freshCells
    (
        IOobject("freshCellMomentum", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimPressure/dimLength, Zero)
    )
{}


// ************************************************************************* //
