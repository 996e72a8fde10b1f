/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pisoStep.H"
#include "familyEntries.H"
#include "fvm.H"
#include "fvc.H"
#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(pisoStep, 0);
    addToRunTimeSelectionTable(flowSolver, pisoStep, dictionary);
    static const familyEntries<flowSolver> entries
    (
        {"nCorrectors", "nNonOrthogonalCorrectors", "momentumPredictor"}
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::pisoStep::correct
(
    const fvVectorMatrix& UEqn,
    const bool last
)
{
    const volScalarField rAU(1.0/UEqn.A());
    const volVectorField HbyA(constrainHbyA(rAU*UEqn.H(), U_, p_));
    surfaceScalarField phiHbyA
    (
        "phiHbyA",
        fvc::flux(HbyA)
      + rho_*fvc::interpolate(rAU)*fvc::ddtCorr(U_, phi_)
    );
    adjustPhi(phiHbyA, U_, p_);
    constrainPressure(p_, U_, phiHbyA, rAU);

    for (label i = 0; i <= nNonOrthogonalCorrectors_; ++i)
    {
        const bool lastOfAll = last && i == nNonOrthogonalCorrectors_;
        fvScalarMatrix pEqn
        (
            fvm::laplacian(rAU, p_) == fvc::div(phiHbyA)
        );
        pEqn.setReference(pRefCell_, pRefValue_);
        const solverPerformance found =
            pEqn.solve(mesh_.solver(p_.select(lastOfAll)));
        if (lastOfAll)
        {
            check(found);
        }

        if (i == nNonOrthogonalCorrectors_)
        {
            phi_ = phiHbyA - pEqn.flux();
        }
    }

    U_ = HbyA - rAU*fvc::grad(p_);
    U_.correctBoundaryConditions();
}


void Foam::capsule::pisoStep::check(const solverPerformance& found)
{
    const scalar residual = found.finalResidual();
    if (!found.converged() && !(residual < roundOff))
    {
        failure_ =
            "the equation of the pressure is not solved: its residual is "
          + Foam::name(residual) + " after " + Foam::name(found.nIterations())
          + " iterations";
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::capsule::pisoStep::readOwn(const dictionary& dict)
{
    const label nCorrectors =
        input::getBetweenOrDefault<label>(dict, "nCorrectors", 2, 1, 1000);
    const label nNonOrthogonalCorrectors = input::getBetweenOrDefault<label>
    (
        dict, "nNonOrthogonalCorrectors", 0, 0, 1000
    );
    momentumPredictor_ =
        input::getOrDefault<bool>(dict, "momentumPredictor", true);
    nCorrectors_ = nCorrectors;
    nNonOrthogonalCorrectors_ = nNonOrthogonalCorrectors;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::pisoStep::pisoStep
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const dimensionedScalar& rho
)
:
    flowSolver(dict, U, p, phi, rho)
{
    pisoStep::readOwn(dict);
    if (rho.value() == 0 || word(mesh_.ddtScheme("ddt(U)")) == "steadyState")
    {
        FatalIOErrorInFunction(dict)
            << "Entry solver is PISO, which needs the inertia of the liquid;"
            << " in Stokes flow: direct, fractionalStep" << exit(FatalIOError);
    }
    mesh_.setFluxRequired(p.name());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::pisoStep::solve
(
    const fvVectorMatrix& UEqn,
    const sources* extra
)
{
    if (extra)
    {
        FatalIOErrorInFunction
        (
            mesh_.solutionDict().subDict("capsuleFoam").subDict("flow")
        )
            << "Entry solver is PISO, which does not iterate: not with"
            << " membranes; with them: direct, fractionalStep"
            << exit(FatalIOError);
    }

    failure_.clear();
    if (momentumPredictor_)
    {
        Foam::solve(UEqn == -fvc::grad(p_));
    }
    for (label i = 1; i <= nCorrectors_; ++i)
    {
        correct(UEqn, i == nCorrectors_);
    }
}


void Foam::capsule::pisoStep::solve
(
    const fvVectorMatrix& UEqn,
    const sources* extra,
    drivingForce& driving
)
{
    if (driving.type() != drivingForce::typeName)
    {
        FatalIOErrorInFunction
        (
            mesh_.solutionDict().subDict("capsuleFoam").subDict("flow")
        )
            << "Entry solver is PISO, which does not know constant/drivingForce"
            << "; with it: direct, fractionalStep" << exit(FatalIOError);
    }
    solve(UEqn, extra);
}
