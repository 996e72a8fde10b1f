/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "extraPressureDrop.H"
#include "membraneSystem.H"
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


void Foam::functionObjects::extraPressureDrop::solveEmpty()
{
    const auto& properties =
        mesh_.lookupObject<IOdictionary>("transportProperties");
    const dimensionedScalar mu("mu", dimPressure*dimTime, properties);

    emptyU_.reset
    (
        new volVectorField("emptyU", mesh_.lookupObject<volVectorField>("U"))
    );
    volVectorField& U = *emptyU_;
    volScalarField p("emptyp", mesh_.lookupObject<volScalarField>("p"));
    surfaceScalarField phi("emptyPhi", fvc::flux(U));

    Info<< type() << ' ' << name() << ": empty channel" << endl;
    autoPtr<capsule::flowSolver> flow
    (
        capsule::flowSolver::New
        (
            mesh_.solutionDict().subDict("capsuleFoam").subDict("flow"),
            U,
            p,
            phi
        )
    );
    const fvVectorMatrix UEqn(-fvm::laplacian(mu, U));
    flow->begin(UEqn);
    flow->solve(UEqn, nullptr);

    emptyDrop_ = drop(p);
    flux_ = gSum(phi.boundaryField()[outlet_]);
    emptyVelocity_ = interpolation<vector>::New("cellPoint", U);
}


Foam::scalar Foam::functionObjects::extraPressureDrop::extraDrop() const
{
    const auto& system =
        mesh_.lookupObject<capsule::membraneSystem>("membraneProperties");
    const capsule::meshPlane& plane = system.plane();

    scalar power = 0;
    for (label i = 0; i < system.size(); ++i)
    {
        const capsule::membrane& m = system[i];
        const capsule::membrane::state& now = m.now();
        const capsule::closedCurve curve(m.basis(), now.interface);

        // Each point is in one cell; on a boundary of processors either does
        capsule::nodalScalars density(m.size());
        for (label node = 0; node < m.size(); ++node)
        {
            const point x = plane.toPoint(now.interface.row(node));
            const label celli = mesh_.findCell(x);
            vector u(Zero);
            if (celli != -1)
            {
                u = emptyVelocity_->interpolate(x, celli);
            }
            reduce(u, maxMagSqrOp<vector>());
            density(node) = plane(u).dot(now.force.row(node));
        }
        power += plane.thickness()*curve.integral(density);
    }
    return -power/flux_;
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
    emptyDrop_(0),
    flux_(0)
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
    if (!emptyU_.valid())
    {
        solveEmpty();
    }
    const scalar now = drop(mesh_.lookupObject<volScalarField>("p"));
    const scalar extra = extraDrop();
    if (Pstream::master())
    {
        file()
            << mesh_.time().timeOutputValue() << tab << now
            << tab << emptyDrop_ << tab << extra << endl;
    }
    return true;
}
