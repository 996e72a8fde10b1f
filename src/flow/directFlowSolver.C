/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "directFlowSolver.H"
#include "profiling.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(directFlowSolver, 0);
    addToRunTimeSelectionTable(flowSolver, directFlowSolver, dictionary);

    typedef Eigen::Triplet<scalar> triplet;
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::directFlowSolver::sparseRows
Foam::capsule::directFlowSolver::gradient(const label axis) const
{
    const direction d = plane_.axis(axis);
    const scalarField& V = mesh_.V();
    std::vector<triplet> entries;
    entries.reserve(4*mesh_.nInternalFaces());

    forAll(mesh_.neighbour(), facei)
    {
        const label P = mesh_.owner()[facei];
        const label N = mesh_.neighbour()[facei];
        const scalar S = mesh_.Sf()[facei][d];
        const scalar w = mesh_.weights()[facei];

        entries.push_back(triplet(P, P, S*w/V[P]));
        entries.push_back(triplet(P, N, S*(1 - w)/V[P]));
        entries.push_back(triplet(N, P, -S*w/V[N]));
        entries.push_back(triplet(N, N, -S*(1 - w)/V[N]));
    }

    forAll(p_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        const scalarField coeffs
        (
            pp.valueInternalCoeffs(mesh_.weights().boundaryField()[patchi])
        );
        forAll(pp, i)
        {
            const label P = pp.patch().faceCells()[i];
            const scalar S = mesh_.Sf().boundaryField()[patchi][i][d];
            entries.push_back(triplet(P, P, S*coeffs[i]/V[P]));
        }
    }

    sparseRows result(mesh_.nCells(), mesh_.nCells());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}


Eigen::SparseMatrix<Foam::scalar> Foam::capsule::directFlowSolver::matrix
(
    const fvVectorMatrix& UEqn
) const
{
    const label n = mesh_.nCells();
    const scalarField& V = mesh_.V();
    std::vector<triplet> entries;
    entries.reserve(50*n);

    const sparseRows grad[2] = {gradient(0), gradient(1)};

    // Momentum: UEqn U + grad p, per volume
    for (label axis = 0; axis < 2; ++axis)
    {
        scalarField diag(UEqn.diag());
        forAll(U_.boundaryField(), patchi)
        {
            const labelUList& cells = mesh_.boundary()[patchi].faceCells();
            const vectorField& coeffs = UEqn.internalCoeffs()[patchi];
            forAll(coeffs, i)
            {
                diag[cells[i]] += coeffs[i][plane_.axis(axis)];
            }
        }
        for (label celli = 0; celli < n; ++celli)
        {
            entries.push_back
            (
                triplet(3*celli + axis, 3*celli + axis, diag[celli]/V[celli])
            );
        }
        const scalarField& lower = UEqn.lower();
        const scalarField& upper = UEqn.upper();
        forAll(mesh_.neighbour(), facei)
        {
            const label P = mesh_.owner()[facei];
            const label N = mesh_.neighbour()[facei];
            entries.push_back
            (
                triplet(3*P + axis, 3*N + axis, upper[facei]/V[P])
            );
            entries.push_back
            (
                triplet(3*N + axis, 3*P + axis, lower[facei]/V[N])
            );
        }
        for (label celli = 0; celli < n; ++celli)
        {
            for (sparseRows::InnerIterator it(grad[axis], celli); it; ++it)
            {
                entries.push_back
                (
                    triplet(3*celli + axis, 3*it.col() + 2, it.value())
                );
            }
        }
    }

    // Continuity: div phi, per volume
    const auto addFlux = [&]
    (
        const label row,
        const label celli,
        const scalar share,
        const vector& S,
        const scalar rAU
    )
    {
        // share of the cell's velocity and of rAU times its pressure gradient
        for (label axis = 0; axis < 2; ++axis)
        {
            const scalar s = share*S[plane_.axis(axis)]/V[row];
            entries.push_back(triplet(3*row + 2, 3*celli + axis, s));
            for (sparseRows::InnerIterator it(grad[axis], celli); it; ++it)
            {
                entries.push_back
                (
                    triplet(3*row + 2, 3*it.col() + 2, rAU*s*it.value())
                );
            }
        }
    };

    forAll(mesh_.neighbour(), facei)
    {
        const label P = mesh_.owner()[facei];
        const label N = mesh_.neighbour()[facei];
        const scalar w = mesh_.weights()[facei];
        const vector& S = mesh_.Sf()[facei];
        const scalar rAU = rAUf_[facei];
        const scalar normal =
            rAU*mesh_.nonOrthDeltaCoeffs()[facei]*mesh_.magSf()[facei];

        for (const label row : {P, N})
        {
            if (row == pRefCell_)
            {
                continue;
            }
            const scalar sign = (row == P ? 1 : -1);
            addFlux(row, P, sign*w, S, rAU);
            addFlux(row, N, sign*(1 - w), S, rAU);
            entries.push_back
            (
                triplet(3*row + 2, 3*P + 2, sign*normal/V[row])
            );
            entries.push_back
            (
                triplet(3*row + 2, 3*N + 2, -sign*normal/V[row])
            );
        }
    }

    forAll(U_.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        const vectorField coeffs
        (
            Up.valueInternalCoeffs(mesh_.weights().boundaryField()[patchi])
        );
        const scalarField gradCoeffs(pp.gradientInternalCoeffs());
        forAll(Up, i)
        {
            const label P = Up.patch().faceCells()[i];
            if (P == pRefCell_)
            {
                continue;
            }
            const vector& S = mesh_.Sf().boundaryField()[patchi][i];
            addFlux(P, P, 1, cmptMultiply(coeffs[i], S), 0);
            if (pp.fixesValue())
            {
                const scalar rAU = rAUf_.boundaryField()[patchi][i];
                addFlux(P, P, 1, S, rAU);
                addFlux(P, P, -1, S, 0);
                entries.push_back
                (
                    triplet
                    (
                        3*P + 2, 3*P + 2,
                       -rAU*gradCoeffs[i]*mag(S)/V[P]
                    )
                );
            }
        }
    }
    if (pRefCell_ != -1)
    {
        entries.push_back
        (
            triplet(3*pRefCell_ + 2, 3*pRefCell_ + 2, 1/pressureScale())
        );
    }

    Eigen::SparseMatrix<scalar> result(3*n, 3*n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::capsule::directFlowSolver::prepare(const fvVectorMatrix& UEqn)
{
    if (stale_)
    {
        addProfiling(factorise, "capsule::directFlowSolver::factorise");
        factors_.compute(matrix(UEqn));
        if (factors_.info() != Eigen::Success)
        {
            FatalErrorInFunction
                << "The coupled matrix cannot be factorised: "
                << factors_.lastErrorMessage().c_str() << exit(FatalError);
        }
        stale_ = false;
    }
}


void Foam::capsule::directFlowSolver::apply
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
        b.segment<2>(3*celli) = plane_(momentum[celli]).transpose();
        b(3*celli + 2) = continuity[celli];
    }
    const nodalScalars x = factors_.solve(b);
    forAll(momentum, celli)
    {
        dU[celli] = plane_.toVector(x.segment<2>(3*celli));
        dp[celli] = x(3*celli + 2);
    }
}


void Foam::capsule::directFlowSolver::applied(const label iterations)
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
    conjugateResiduals(dict, U, p, phi, rho),
    refactor_
    (
        input::getBetweenOrDefault<label>(dict, "refactor", 6, 1, 10000)
    ),
    stale_(true)
{
    if (Pstream::parRun())
    {
        FatalIOErrorInFunction(dict)
            << "Entry solver is direct, which runs on one processor only;"
            << " in parallel: fractionalStep" << exit(FatalIOError);
    }
}
