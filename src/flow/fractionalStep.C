/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fractionalStep.H"
#include "fvm.H"
#include "fvc.H"
#include "fixedValueFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"
#include "slipFvPatchFields.H"
#include "wallPolyPatch.H"
#include "profiling.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(fractionalStep, 0);
    addToRunTimeSelectionTable(flowSolver, fractionalStep, dictionary);

    //- A linear solver's entries. Also with tolerance 0 a component that is
    //  zero, as that around the axis of a wedge, is solved as it is: no relTol
    //  of a residual of zero is ever reached
    static dictionary controlsOf(const dictionary& solver)
    {
        dictionary controls(solver);
        scalar tolerance;
        if (controls.readIfPresent("tolerance", tolerance))
        {
            controls.set("tolerance", max(tolerance, ROOTVSMALL));
        }
        return controls;
    }

    //- Solve without a line in the log for each of the many sweeps
    template<class Type>
    static void solveQuietly
    (
        fvMatrix<Type>& equation,
        const dictionary& controls
    )
    {
        const int said = SolverPerformance<Type>::debug;
        SolverPerformance<Type>::debug = 0;
        equation.solve(controls);
        SolverPerformance<Type>::debug = said;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::wordList Foam::capsule::fractionalStep::homogeneous
(
    const GeometricField<Type, fvPatchField, volMesh>& field
)
{
    wordList types(field.boundaryField().size());
    forAll(types, patchi)
    {
        const fvPatchField<Type>& pf = field.boundaryField()[patchi];
        types[patchi] =
            polyPatch::constraintType(pf.patch().type())
          ? pf.patch().type()
          : pf.fixesValue() && !pf.assignable()
          ? fixedValueFvPatchField<Type>::typeName
          : isA<slipFvPatchField<Type>>(pf)
          ? slipFvPatchField<Type>::typeName
          : zeroGradientFvPatchField<Type>::typeName;
    }
    return types;
}


Foam::scalar Foam::capsule::fractionalStep::wallFriction() const
{
    scalar walls = 0;
    symmTensor facing(Zero);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<wallPolyPatch>(pp))
        {
            const vectorField& S = pp.faceAreas();
            walls += gSum(mag(S));
            facing += gSum(sqr(S)/mag(S));
        }
    }
    // In space walls that face in one direction are plates
    const bool plates =
        directions_.spatial()
      ? magSqr(facing) > 0.8*sqr(walls)
      : !directions_.axisymmetric();
    const scalar perDiameter = walls/(4*gSum(mesh_.V().field()));

    return (plates ? 48 : 32)*sqr(perDiameter);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::capsule::fractionalStep::setPreconditioner(const fvVectorMatrix& UEqn)
{
    // They may have been read again
    momentumControls_ = controlsOf(mesh_.solverDict("U"));
    pressureControls_ = controlsOf(mesh_.solverDict("p"));

    // The matrix of UEqn with homogeneous boundary conditions
    momentumEqn_.reset(new fvVectorMatrix(dU_, UEqn.dimensions()));
    momentumEqn_->lduMatrix::operator=(UEqn);
    momentumEqn_->internalCoeffs() = UEqn.internalCoeffs();
    momentumEqn_->boundaryCoeffs() = UEqn.boundaryCoeffs();
    forAll(dU_.boundaryField(), patchi)
    {
        if (!dU_.boundaryField()[patchi].coupled())
        {
            momentumEqn_->boundaryCoeffs()[patchi] = Zero;
        }
    }

    // The sum of a row is the coefficient of the time derivative; the
    // off-diagonals are the viscosity's, and differ by the convection
    const scalarField& lower = UEqn.lower();
    const scalarField& upper = UEqn.upper();
    scalarField sum(UEqn.diag());
    scalar viscous = 0;
    scalar geometric = 0;
    forAll(upper, facei)
    {
        sum[mesh_.owner()[facei]] += upper[facei];
        sum[mesh_.neighbour()[facei]] += lower[facei];
        viscous -= 0.5*(lower[facei] + upper[facei]);
        geometric +=
            mesh_.magSf()[facei]*mesh_.nonOrthDeltaCoeffs()[facei];
    }
    forAll(dU_.boundaryField(), patchi)
    {
        if (dU_.boundaryField()[patchi].coupled())
        {
            // Diagonal and off-diagonal parts of coupled faces
            const labelUList& cells = mesh_.boundary()[patchi].faceCells();
            forAll(cells, i)
            {
                const label axis = directions_.axis(0);
                sum[cells[i]] +=
                    UEqn.internalCoeffs()[patchi][i][axis]
                  - UEqn.boundaryCoeffs()[patchi][i][axis];
            }
        }
    }
    reduce(viscous, sumOp<scalar>());
    reduce(geometric, sumOp<scalar>());
    mu_ = viscous/geometric;

    friction_ = sum/mesh_.V().field() + mu_*wallFriction();

    if (!pressureEqn_.valid())
    {
        pressureEqn_.reset(new fvScalarMatrix(fvm::laplacian(psi_)));
        pressureEqn_->setReference(pRefCell_, 0);
    }
}


void Foam::capsule::fractionalStep::precondition
(
    const vectorField& momentum,
    const scalarField& continuity,
    vectorField& dU,
    scalarField& dp
)
{
    addProfiling(sweep, "capsule::fractionalStep");

    // Momentum predictor
    dU_ = dimensionedVector(dimVelocity, Zero);
    momentumEqn_->source() = momentum*mesh_.V().field();
    solveQuietly(*momentumEqn_, momentumControls_);

    // Pressure equation: what is left of continuity
    scalarField left
    (
        continuity - fvc::div(fvc::flux(dU_))().primitiveField()
    );
    if (free_)
    {
        // The reference cell balances the others; its row is the level
        if (pRefCell_ != -1)
        {
            left[pRefCell_] = 0;
        }
        const scalar others = gSum(left*mesh_.V().field());
        if (pRefCell_ != -1)
        {
            left[pRefCell_] = -others/mesh_.V()[pRefCell_];
        }
    }
    psi_ = dimensionedScalar(psi_.dimensions(), Zero);
    pressureEqn_->source() = left*mesh_.V().field();
    solveQuietly(*pressureEqn_, pressureControls_);

    dU = dU_.primitiveField() + fvc::grad(psi_)().primitiveField();
    dp = mu_*left - friction_*psi_.primitiveField();
    if (free_)
    {
        scalar shift = -GREAT;
        if (pRefCell_ != -1)
        {
            shift = continuity[pRefCell_]*pressureScale() - dp[pRefCell_];
        }
        dp += returnReduce(shift, maxOp<scalar>());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::fractionalStep::fractionalStep
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const dimensionedScalar& rho
)
:
    GCR(dict, U, p, phi, rho),
    dU_
    (
        IOobject("dU", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimVelocity, Zero),
        homogeneous(U)
    ),
    psi_
    (
        IOobject("psi", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimVelocity*dimLength, Zero),
        homogeneous(p)
    ),
    free_(p.needReference()),
    mu_(0)
{}
