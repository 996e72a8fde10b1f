/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "directFlowSolver.H"
#include "cyclicFvPatch.H"
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

Foam::List<Foam::capsule::directFlowSolver::link>
Foam::capsule::directFlowSolver::links(const fvVectorMatrix& UEqn) const
{
    DynamicList<link> result(mesh_.nInternalFaces());
    const scalarField& lower = UEqn.lower();
    const scalarField& upper = UEqn.upper();
    const surfaceScalarField& delta = mesh_.nonOrthDeltaCoeffs();

    forAll(mesh_.neighbour(), facei)
    {
        result.append
        ({
            mesh_.owner()[facei], mesh_.neighbour()[facei],
            mesh_.Sf()[facei], mesh_.weights()[facei], delta[facei],
            rAUf_[facei], upper[facei], lower[facei]
        });
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!isA<cyclicFvPatch>(patch))
        {
            continue;
        }
        const auto& cyclic = refCast<const cyclicFvPatch>(patch);
        if (!cyclic.owner())
        {
            continue;
        }
        const label patchi = patch.index();
        const labelUList& here = patch.faceCells();
        const labelUList& there = cyclic.neighbPatch().faceCells();
        const vectorField& ofThere = UEqn.boundaryCoeffs()[patchi];
        const vectorField& ofHere =
            UEqn.boundaryCoeffs()[cyclic.neighbPatch().index()];
        forAll(here, i)
        {
            // The same for all components without a rotation
            const direction d = plane_.axis(0);
            result.append
            ({
                here[i], there[i],
                patch.Sf()[i], patch.weights()[i],
                delta.boundaryField()[patchi][i],
                rAUf_.boundaryField()[patchi][i],
               -ofThere[i][d], -ofHere[i][d]
            });
        }
    }
    return List<link>(std::move(result));
}


Foam::capsule::directFlowSolver::sparseRows
Foam::capsule::directFlowSolver::gradient
(
    const UList<link>& links,
    const label axis
) const
{
    const direction d = plane_.axis(axis);
    const scalarField& V = mesh_.V();
    std::vector<triplet> entries;
    entries.reserve(4*links.size());

    for (const link& l : links)
    {
        const scalar S = l.S[d];
        const scalar w = l.weight;

        entries.push_back(triplet(l.P, l.P, S*w/V[l.P]));
        entries.push_back(triplet(l.P, l.N, S*(1 - w)/V[l.P]));
        entries.push_back(triplet(l.N, l.P, -S*w/V[l.N]));
        entries.push_back(triplet(l.N, l.N, -S*(1 - w)/V[l.N]));
    }

    forAll(p_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        if (pp.coupled())
        {
            continue;
        }
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

    const List<link> links(this->links(UEqn));
    const sparseRows grad[2] = {gradient(links, 0), gradient(links, 1)};

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
        for (const link& l : links)
        {
            entries.push_back
            (
                triplet(3*l.P + axis, 3*l.N + axis, l.upper/V[l.P])
            );
            entries.push_back
            (
                triplet(3*l.N + axis, 3*l.P + axis, l.lower/V[l.N])
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

    for (const link& l : links)
    {
        const scalar normal = l.rAU*l.delta*mag(l.S);

        for (const label row : {l.P, l.N})
        {
            if (row == pRefCell_)
            {
                continue;
            }
            const scalar sign = (row == l.P ? 1 : -1);
            addFlux(row, l.P, sign*l.weight, l.S, l.rAU);
            addFlux(row, l.N, sign*(1 - l.weight), l.S, l.rAU);
            entries.push_back
            (
                triplet(3*row + 2, 3*l.P + 2, sign*normal/V[row])
            );
            entries.push_back
            (
                triplet(3*row + 2, 3*l.N + 2, -sign*normal/V[row])
            );
        }
    }

    forAll(U_.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        if (pp.coupled())
        {
            continue;
        }
        const vectorField coeffs(fluxCoeffs(patchi));
        const scalarField gradCoeffs(pp.gradientInternalCoeffs());
        forAll(Up, i)
        {
            const label P = Up.patch().faceCells()[i];
            if (P == pRefCell_)
            {
                continue;
            }
            const vector& S = mesh_.Sf().boundaryField()[patchi][i];
            addFlux(P, P, 1, coeffs[i], 0);
            if (followsPressure(patchi))
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


void Foam::capsule::directFlowSolver::factorise(const fvVectorMatrix& UEqn)
{
    addProfiling(factorise, "capsule::directFlowSolver::factorise");
    factors_.compute(matrix(UEqn));
    if (factors_.info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "The coupled matrix cannot be factorised: "
            << factors_.lastErrorMessage().c_str() << exit(FatalError);
    }
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
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::directFlowSolver::restore()
{
    GCR::restore();
    stale_ = staleAtStart_ || made_;
}
