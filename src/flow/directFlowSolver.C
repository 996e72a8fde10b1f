/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "directFlowSolver.H"
#include "familyEntries.H"
#include "profiling.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(directFlowSolver, 0);
    addToRunTimeSelectionTable(flowSolver, directFlowSolver, dictionary);
    static const familyEntries<flowSolver> entries({"refactor"});
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::directFlowSolver::factorise(const fvVectorMatrix& UEqn)
{
    addProfiling(factorise, "capsule::directFlowSolver::factorise");
    factors_.compute(matrix(UEqn));
    Info<< "Factorised the coupled matrix: " << factors_.entries()
        << " entries" << endl;
    factorised_.reset(new fvVectorMatrix(UEqn));
    stale_ = false;
    made_ = true;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::capsule::directFlowSolver::readOwn(const dictionary& dict)
{
    const label refactor =
        input::getBetweenOrDefault<label>(dict, "refactor", 6, 1, 10000);
    GCR::readOwn(dict);
    refactor_ = refactor;
}


void Foam::capsule::directFlowSolver::setPreconditioner(const fvVectorMatrix& UEqn)
{
    made_ = false;
    staleAtStart_ = stale_;
    if (stale_)
    {
        factorise(UEqn);
    }
    else if (!varies_)
    {
        varies_ =
            UEqn.diag() != factorised_->diag()
         || UEqn.upper() != factorised_->upper();
    }
}


void Foam::capsule::directFlowSolver::precondition
(
    const vectorField& momentum,
    const scalarField& continuity,
    vectorField& dU,
    scalarField& dp
)
{
    addProfiling(substitute, "capsule::directFlowSolver::substitute");

    nodalScalars b(3*mesh_.nCells());
    forAll(momentum, celli)
    {
        b.segment<2>(3*celli) = directions_(momentum[celli]).transpose();
        b(3*celli + 2) = continuity[celli];
    }
    const nodalScalars x = factors_.solve(b);
    forAll(momentum, celli)
    {
        dU[celli] = directions_.toVector(x.segment<2>(3*celli));
        dp[celli] = x(3*celli + 2);
    }
}


void Foam::capsule::directFlowSolver::preconditioned(const label iterations)
{
    stale_ = stale_ || iterations > refactor_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::directFlowSolver::directFlowSolver
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const dimensionedScalar& rho
)
:
    GCR(dict, U, p, phi, rho),
    factors_(directions_.toNodes(mesh_.cellCentres())),
    stale_(true),
    made_(false),
    staleAtStart_(true),
    varies_(word(mesh_.ddtScheme("ddt(U)")) != "steadyState")
{
    directFlowSolver::readOwn(dict);
    if (Pstream::parRun())
    {
        FatalIOErrorInFunction(dict)
            << "Entry solver is direct, which runs on one processor only;"
            << " in parallel: fractionalStep" << exit(FatalIOError);
    }
    if (directions_.size() == 3)
    {
        FatalIOErrorInFunction(dict)
            << "Entry solver is direct, which is for plane meshes and wedges;"
            << " in space: fractionalStep" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::directFlowSolver::restore()
{
    GCR::restore();
    stale_ = staleAtStart_ || made_;
}
