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
            const direction d = directions_.axis(0);
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
    const direction d = directions_.axis(axis);
    const scalarField& V = mesh_.V();
    triplets entries;
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


void Foam::capsule::directFlowSolver::addMomentum
(
    const fvVectorMatrix& UEqn,
    const UList<link>& links,
    const sparseRows (&grad)[2],
    triplets& entries
) const
{
    const label n = mesh_.nCells();
    const scalarField& V = mesh_.V();

    for (label axis = 0; axis < 2; ++axis)
    {
        scalarField diag(UEqn.diag());
        forAll(U_.boundaryField(), patchi)
        {
            const labelUList& cells = mesh_.boundary()[patchi].faceCells();
            const vectorField& coeffs = UEqn.internalCoeffs()[patchi];
            forAll(coeffs, i)
            {
                diag[cells[i]] += coeffs[i][directions_.axis(axis)];
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
}


void Foam::capsule::directFlowSolver::addFlux
(
    const label row,
    const label celli,
    const scalar share,
    const vector& S,
    const scalar rAU,
    const sparseRows (&grad)[2],
    triplets& entries
) const
{
    for (label axis = 0; axis < 2; ++axis)
    {
        const scalar s = share*S[directions_.axis(axis)]/mesh_.V()[row];
        entries.push_back(triplet(3*row + 2, 3*celli + axis, s));
        for (sparseRows::InnerIterator it(grad[axis], celli); it; ++it)
        {
            entries.push_back
            (
                triplet(3*row + 2, 3*it.col() + 2, rAU*s*it.value())
            );
        }
    }
}


void Foam::capsule::directFlowSolver::addContinuity
(
    const UList<link>& links,
    const sparseRows (&grad)[2],
    triplets& entries
) const
{
    const scalarField& V = mesh_.V();

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
            addFlux
            (
                row, l.P, sign*l.weight, l.S, l.rAU, grad, entries
            );
            addFlux
            (
                row, l.N, sign*(1 - l.weight), l.S, l.rAU, grad, entries
            );
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
}


void Foam::capsule::directFlowSolver::addBoundaryFluxes
(
    const sparseRows (&grad)[2],
    triplets& entries
) const
{
    const scalarField& V = mesh_.V();

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
            addFlux(P, P, 1, coeffs[i], 0, grad, entries);
            if (followsPressure(patchi))
            {
                const scalar rAU = rAUf_.boundaryField()[patchi][i];
                addFlux(P, P, 1, S, rAU, grad, entries);
                addFlux(P, P, -1, S, 0, grad, entries);
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
}


Eigen::SparseMatrix<Foam::scalar> Foam::capsule::directFlowSolver::matrix
(
    const fvVectorMatrix& UEqn
) const
{
    const label n = mesh_.nCells();
    triplets entries;
    entries.reserve(50*n);
    const List<link> links(this->links(UEqn));
    const sparseRows grad[2] = {gradient(links, 0), gradient(links, 1)};

    addMomentum(UEqn, links, grad, entries);
    addContinuity(links, grad, entries);
    addBoundaryFluxes(grad, entries);
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


// ************************************************************************* //
