/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "drivingForce.H"
#include "IOdictionary.H"
#include "sigFpe.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::capsule::drivingForce> Foam::capsule::drivingForce::New
(
    const fvMesh& mesh
)
{
    IOobject io
    (
        "drivingForce",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (io.globalFilePath(IOdictionary::typeName).empty())
    {
        return autoPtr<drivingForce>(new drivingForce);
    }
    sigFpe::ignore untrapped;
    const IOdictionary dict(io);
    const auto& table = *dictionaryConstructorTablePtr_;
    const word type(input::choice(dict, "type", table.sortedToc()));
    Info<< "Driving force: " << type << endl;

    return autoPtr<drivingForce>(table[type](dict, mesh));
}
