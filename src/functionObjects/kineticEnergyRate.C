/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "kineticEnergyRate.H"
#include "timeScheme.H"
#include "wholeFile.H"
#include "input.H"
#include "IOdictionary.H"
#include "fvc.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace kineticEnergyRate
{

static IOobject file(const fvMesh& mesh, const IOobject::readOption read)
{
    return IOobject
    (
        "kineticEnergyRate",
        mesh.time().timeName(),
        "uniform",
        mesh.time(),
        read,
        IOobject::NO_WRITE,
        false
    );
}


static bool isSteady(const fvMesh& mesh)
{
    return timeScheme(mesh, "ddt(U)", 0).c == 0;
}

} // End namespace kineticEnergyRate
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::kineticEnergyRate::ofStep
(
    const volVectorField& U,
    const scalar density
)
{
    return
        density
       *gSum
        (
            (U.primitiveField() & fvc::ddt(U)().primitiveField())
           *U.mesh().V()
        );
}


void Foam::capsule::kineticEnergyRate::write
(
    const volVectorField& U,
    const scalar density
)
{
    if (!isSteady(U.mesh()))
    {
        IOdictionary dict(file(U.mesh(), IOobject::NO_READ));
        dict.add("rate", ofStep(U, density));
        writeAtomically(dict, IOstream::ASCII);
    }
}


bool Foam::capsule::kineticEnergyRate::read(const fvMesh& mesh, scalar& rate)
{
    if (isSteady(mesh))
    {
        rate = 0;
        return true;
    }
    IOobject io(file(mesh, IOobject::MUST_READ));
    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        return false;
    }
    rate = input::get<scalar>(IOdictionary(io), "rate");
    return true;
}
