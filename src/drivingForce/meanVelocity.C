/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meanVelocity.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace drivingForces
{
    defineTypeNameAndDebug(meanVelocity, 0);
    addToRunTimeSelectionTable(drivingForce, meanVelocity, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::drivingForces::meanVelocity::meanVelocity
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    directions_(mesh),
    velocity_(readAlongPeriods(dict, "velocity", dimVelocity, directions_)),
    gradient_
    (
        IOobject
        (
            "meanPressureGradient",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        dimensionedVector(dimPressure/dimLength, Zero)
    )
{
    if (!(mag(gradient_.value()) <= input::largest))
    {
        FatalErrorInFunction
            << "The value in " << gradient_.objectPath() << " is "
            << gradient_.value() << "; its magnitude may be up to "
            << input::largest << nl
            << "    Without the file the gradient is found anew."
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vectorField Foam::capsule::drivingForces::meanVelocity::fixed() const
{
    vectorField directions;
    for (const solvedVector& p : directions_.images().periods())
    {
        directions.append(directions_.toVector(p.normalized()));
    }
    return directions;
}


void Foam::capsule::drivingForces::meanVelocity::found(const vector& force)
{
    gradient_.value() = -force;
    Info<< "Mean velocity " << velocity_ << ", mean pressure gradient "
        << gradient_.value() << endl;
}
