/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "GCR.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::GCR::setForceResponses
(
    const fvVectorMatrix& UEqn,
    const sources* extra,
    const vectorField& along
)
{
    const nodalScalars x = packed(U_, p_);
    const nodalScalars zero = nodalScalars::Zero(x.size());
    const auto atRest = [&](const vector& force)
    {
        force_ = force;
        unpack(zero);
        return residual(UEqn, extra);
    };
    const vector force = force_;
    const nodalScalars idle = atRest(Zero);
    forceResponses_.setSize(along.size());
    forAll(along, i)
    {
        if (forceResponses_[i].size() != x.size())
        {
            forceResponses_[i] = zero;
        }
        // A force as large as what else acts, so that nothing is lost in the
        // differences
        const scalar unit = globalNorm(atRest(along[i]) - idle);
        const scalar acting = globalNorm(idle);
        const scalar size = (acting > VSMALL*unit ? acting/unit : 1);

        nodalScalars response = size*forceResponses_[i];
        const string unsolved = converge
        (
            UEqn, extra, atRest(size*along[i]), &idle, size*unit,
            "response to force", response
        );
        if (!unsolved.empty())
        {
            unsolvedResponse_ = unsolved;
        }
        forceResponses_[i] = response/size;
    }
    force_ = force;
    unpack(x);
    forceResponsesKnown_ = true;
}


Foam::vector Foam::capsule::GCR::mean(const nodalScalars& x) const
{
    const scalarField& V = mesh_.V();
    vectorField U(V.size());
    scalarField p(V.size());
    unpack(x, U, p);
    return gSum(V*U)/gSum(V);
}


void Foam::capsule::GCR::setMean
(
    const vectorField& along,
    const vector& velocity
)
{
    nodalScalars x = packed(U_, p_);
    const vector missing = velocity - mean(x);

    nodalScalars missed(along.size());
    nodalMatrix gained(along.size(), along.size());
    forAll(along, i)
    {
        missed(i) = missing & along[i];
        forAll(along, j)
        {
            gained(i, j) = mean(forceResponses_[j]) & along[i];
        }
    }
    const nodalScalars change = gained.partialPivLu().solve(missed);

    forAll(along, i)
    {
        force_ += change(i)*along[i];
        x += change(i)*forceResponses_[i];
    }
    unpack(x);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::GCR::solve
(
    const fvVectorMatrix& UEqn,
    const sources* extra,
    drivingForce& driving
)
{
    force_ = driving.force();
    const vectorField along(driving.fixed());
    if (along.empty())
    {
        solve(UEqn, extra);
        return;
    }

    if (!forceResponsesKnown_)
    {
        setForceResponses(UEqn, extra, along);
    }
    if
    (
        force_ == vector(Zero)
     && word(mesh_.ddtScheme("ddt(U)")) == "steadyState"
    )
    {
        // From rest: a flow that starts with the mean velocity would ask for no
        // force, and leave nothing to measure residuals by
        unpack(nodalScalars::Zero(packed(U_, p_).size()));
    }
    setMean(along, driving.velocity());
    solve(UEqn, extra);
    setMean(along, driving.velocity());

    // The fluxes of the fields
    residual(UEqn, extra);
    driving.found(force_);
}
