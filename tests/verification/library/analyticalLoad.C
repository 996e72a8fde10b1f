/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "analyticalLoad.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(analyticalLoad, 0);
    addToRunTimeSelectionTable(membraneLoad, analyticalLoad, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalLoad::analyticalLoad
(
    const dictionary&,
    const fvMesh& mesh
)
:
    time_(mesh.time()),
    exact_(analyticalSolution::New(mesh))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::analyticalLoad::force
(
    const closedSurface& surface
) const
{
    return exact_->force(surface, time_.value());
}
