/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meanPressureGradient.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace drivingForces
{
    defineTypeNameAndDebug(meanPressureGradient, 0);
    addToRunTimeSelectionTable(drivingForce, meanPressureGradient, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::drivingForces::meanPressureGradient::meanPressureGradient
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    gradient_
    (
        readAlongPeriods
        (
            dict, "pressureGradient", dimPressure/dimLength, solvedDirections(mesh)
        )
    )
{}
