/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "GCR.H"
#include "familyEntries.H"
#include "boundaryTypes.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    static const familyEntries<flowSolver> entries
    (
        {"tolerance", "maxIter", "directions"}
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::GCR::globalDot
(
    const nodalScalars& a,
    const nodalScalars& b
)
{
    return returnReduce(scalar(a.dot(b)), sumOp<scalar>());
}


Foam::scalar Foam::capsule::GCR::globalNorm(const nodalScalars& a)
{
    return Foam::sqrt(globalDot(a, a));
}


void Foam::capsule::GCR::addDirection
(
    const fvVectorMatrix& UEqn,
    const sources* extra,
    const nodalScalars& r,
    const nodalScalars& atRest,
    const scalar size
)
{
    vectorField momentum(mesh_.nCells());
    scalarField continuity(mesh_.nCells());
    vectorField dU(mesh_.nCells(), Zero);
    scalarField dp(mesh_.nCells(), Zero);
    unscale(r*(size/globalNorm(r)), momentum, continuity);
    precondition(momentum, continuity, dU, dp);

    // The matrix times the unknowns, from the affine residual: their size is
    // that of the flow, so that little is lost in the difference
    searchDirection d;
    d.unknowns = packed(dU, dp);
    unpack(d.unknowns);
    d.residual = atRest - residual(UEqn, extra);

    for (const searchDirection& other : searchDirections_)
    {
        const scalar share = globalDot(d.residual, other.residual);
        d.residual -= share*other.residual;
        d.unknowns -= share*other.unknowns;
    }
    const scalar length = globalNorm(d.residual) + VSMALL;
    d.residual /= length;
    d.unknowns /= length;

    while (label(searchDirections_.size()) >= maxDirections_)
    {
        searchDirections_.pop_front();
    }
    searchDirections_.push_back(std::move(d));
}


Foam::string Foam::capsule::GCR::ended
(
    const char* what,
    const scalar initial,
    const scalar final,
    const label iter,
    const bool solved
) const
{
    Info<< type() << ":  Solving for " << what << ", Initial residual = "
        << initial << ", Final residual = " << final
        << ", No Iterations " << iter
        << (solved ? "" : ", above the tolerance") << endl;

    if (solved)
    {
        return string::null;
    }
    return
        "the flow is not solved: the residual of " + string(what) + " is "
      + Foam::name(final) + " after " + Foam::name(iter)
      + " iterations, above the tolerance of " + Foam::name(tolerance_);
}


Foam::string Foam::capsule::GCR::converge
(
    const fvVectorMatrix& UEqn,
    const sources* extra,
    const nodalScalars& atRest,
    const nodalScalars* offset,
    const scalar reference,
    const char* what,
    nodalScalars& x
)
{
    const auto evaluate = [&]()
    {
        unpack(x);
        nodalScalars r = residual(UEqn, extra);
        if (offset)
        {
            r -= *offset;
        }
        return r;
    };
    nodalScalars r = evaluate();
    scalar norm = globalNorm(r);
    const scalar initial = norm;
    const scalar from = termSize();

    const auto addAlong = [&](const searchDirection& d)
    {
        const scalar step = globalDot(r, d.residual);
        x += step*d.unknowns;
        r -= step*d.residual;
    };
    for (const searchDirection& d : searchDirections_)
    {
        addAlong(d);
    }

    label iter = 0;
    scalar last;
    do
    {
        while (globalNorm(r) > 0.9*tolerance_*reference && iter < maxIter_)
        {
            ++iter;
            addDirection(UEqn, extra, r, atRest, reference);
            addAlong(searchDirections_.back());
        }

        // Round-off apart, the residual is that of the directions
        r = evaluate();
        last = norm;
        norm = globalNorm(r);
    }
    while
    (
        norm > tolerance_*reference && norm < 0.5*last && iter < maxIter_
    );

    preconditioned(iter);

    // Below the tolerance, or as far as round-off of the terms lets it
    const bool solved =
        norm <= tolerance_*reference
     || norm <= roundOff*max(from, termSize());

    return ended(what, initial/reference, norm/reference, iter, solved);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::capsule::GCR::readOwn(const dictionary& dict)
{
    const scalar tolerance =
        input::getBetweenOrDefault<scalar>(dict, "tolerance", 1e-8, 1e-15, 0.1);
    const label maxIter =
        input::getBetweenOrDefault<label>(dict, "maxIter", 100, 1, 10000);
    maxDirections_ =
        input::getBetweenOrDefault<label>(dict, "directions", 60, 1, 10000);
    tolerance_ = tolerance;
    maxIter_ = maxIter;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::GCR::GCR
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const dimensionedScalar& rho
)
:
    flowSolver(dict, U, p, phi, rho),
    forceResponsesKnown_(false)
{
    GCR::readOwn(dict);
    boundaryTypes::checkAffine(U, p);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField>
Foam::capsule::GCR::convectingFlux() const
{
    const surfaceScalarField& old = phi_.oldTime();

    if (old.nOldTimes() < 1 || phi_.time().timeIndex() < 2)
    {
        old.oldTime();
        return tmp<surfaceScalarField>(new surfaceScalarField(old));
    }

    const scalar ratio =
        phi_.time().deltaTValue()/phi_.time().deltaT0Value();
    return (1 + ratio)*old - ratio*old.oldTime();
}


void Foam::capsule::GCR::begin(const fvVectorMatrix& UEqn)
{
    searchDirections_.clear();
    forceResponsesKnown_ = false;
    unsolvedResponse_.clear();
    set(UEqn);
    setPreconditioner(UEqn);
}


void Foam::capsule::GCR::restore()
{
    flowSolver::restore();
    searchDirections_.clear();
    forceResponses_.clear();
    forceResponsesKnown_ = false;
}


void Foam::capsule::GCR::solve
(
    const fvVectorMatrix& UEqn,
    const sources* extra
)
{
    nodalScalars x = packed(U_, p_);

    // Reference: what the fluid at rest leaves of the equations, at least
    // what round-off leaves of the flow that was
    const scalar least = roundOff*termSize();
    unpack(nodalScalars::Zero(x.size()));
    const nodalScalars atRest = residual(UEqn, extra);
    const scalar reference = max(globalNorm(atRest), least) + VSMALL;

    failure_ = converge(UEqn, extra, atRest, nullptr, reference, "U, p", x);
    if (failure_.empty())
    {
        failure_ = unsolvedResponse_;
    }
}
