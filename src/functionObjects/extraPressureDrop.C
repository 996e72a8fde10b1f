/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "extraPressureDrop.H"
#include "flowSolver.H"
#include "fvm.H"
#include "fvc.H"
#include "IOdictionary.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(extraPressureDrop, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        extraPressureDrop,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::functionObjects::extraPressureDrop::patch
(
    const dictionary& dict,
    const word& entry
) const
{
    const word name(dict.get<word>(entry));
    const label patchi = mesh_.boundaryMesh().findPatchID(name);
    if (patchi == -1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << name << ", which is no patch;"
            << " permitted: " << mesh_.boundaryMesh().names()
            << exit(FatalIOError);
    }
    return patchi;
}


Foam::scalar Foam::functionObjects::extraPressureDrop::drop
(
    const volScalarField& p
) const
{
    const auto average = [&](const label patchi)
    {
        const scalarField& area = mesh_.magSf().boundaryField()[patchi];
        return gSum(p.boundaryField()[patchi]*area)/gSum(area);
    };
    return average(inlet_) - average(outlet_);
}


Foam::scalar Foam::functionObjects::extraPressureDrop::emptyDrop() const
{
    const auto& properties =
        mesh_.lookupObject<IOdictionary>("transportProperties");
    const dimensionedScalar mu("mu", dimPressure*dimTime, properties);

    volVectorField U("emptyU", mesh_.lookupObject<volVectorField>("U"));
    volScalarField p("emptyp", mesh_.lookupObject<volScalarField>("p"));
    surfaceScalarField phi("emptyPhi", fvc::flux(U));

    dictionary controls
    (
        mesh_.solutionDict().subDict("capsuleFoam").subDict("flow")
    );
    controls.set("tolerance", 1e-8);

    Info<< type() << ' ' << name() << ": empty channel" << endl;
    autoPtr<capsule::flowSolver> flow
    (
        capsule::flowSolver::New(controls, U, p, phi)
    );
    const fvVectorMatrix UEqn(-fvm::laplacian(mu, U));
    flow->begin(UEqn);
    flow->solve(UEqn, nullptr);
    return drop(p);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::extraPressureDrop::extraPressureDrop
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, typeName, dict),
    inlet_(-1),
    outlet_(-1),
    empty_(-1)
{
    read(dict);

    file().precision(12);
    writeHeader(file(), "Pressure drop [Pa]");
    writeCommented(file(), "Time");
    writeTabbed(file(), "drop");
    writeTabbed(file(), "emptyDrop");
    writeTabbed(file(), "extraDrop");
    file() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::extraPressureDrop::read(const dictionary& dict)
{
    inlet_ = patch(dict, "inlet");
    outlet_ = patch(dict, "outlet");
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::extraPressureDrop::execute()
{
    return true;
}


bool Foam::functionObjects::extraPressureDrop::write()
{
    if (empty_ < 0)
    {
        empty_ = emptyDrop();
    }
    const scalar now = drop(mesh_.lookupObject<volScalarField>("p"));
    if (Pstream::master())
    {
        file()
            << mesh_.time().timeOutputValue() << tab << now << tab << empty_
            << tab << now - empty_ << endl;
    }
    return true;
}
