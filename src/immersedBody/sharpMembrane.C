/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sharpMembrane.H"
#include "freeSpaceResponse.H"
#include "profiling.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(sharpMembrane, 0);
    addToRunTimeSelectionTable(immersedMembrane, sharpMembrane, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::sharpMembrane::setLiquids()
{
    around_.setStep();
    liquids_.density = around_.rho();
    liquids_.viscosity = around_.mu();
    liquids_.ratio = ratio_;
}


void Foam::capsule::sharpMembrane::setScale()
{
    if (liquids_.contrast())
    {
        const scalar inertia = around_.rho()*flowScheme().c*sqr(levelSet().width());
        liquids_.scaling = momentumScaling
        (
            ratio_, inertia > 0 ? around_.mu()/inertia : GREAT
        );
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::velocity
(
    const volVectorField& U,
    const volScalarField& p
)
{
    fluid_ = fit()(U, liquids_.contrast() ? &p : nullptr);

    return
        fluid_.value.leftCols(basis().nComponents())
      + basis().unpack(unresolvedResponse_.col(0));
}


Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::contrastTraction
(
    const solvedVector& driving
)
{
    if (!liquids_.contrast())
    {
        return immersedMembrane::contrastTraction(driving);
    }
    return contrast_.force
    (
        fluid_,
        resolvedForce(),
        basis().unpack(unresolvedResponse_.col(1)),
        (surface().nodes().rowwise() - pressureOrigin())*driving.transpose(),
        inertia_.momentumRate(flowScheme()),
        membrane_.now()
    );
}


Foam::capsule::nodalScalars
Foam::capsule::sharpMembrane::inertiaResidual() const
{
    return
        inertia_.unknown()
      ? inertia_.residual(flowScheme(), excess())
      : nodalScalars(0);
}


Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::inertiaCorrection
(
    const nodalScalars& df,
    const nodalScalars& residual
) const
{
    return inertia_.correction(df, residual);
}


Foam::capsule::nodalScalars
Foam::capsule::sharpMembrane::inertiaResidualChange
(
    const nodalScalars& dx
) const
{
    const label n = nForce();
    return
        inertia_.unknown()
      ? inertia_.residualChange(dx.head(n), dx.tail(n))
      : nodalScalars(0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sharpMembrane::sharpMembrane
(
    const word& name,
    const dictionary& dict,
    const solvedDirections& directions,
    const fvMesh& mesh,
    const scalar density,
    const scalar viscosity
)
:
    immersedMembrane(name, dict, directions, mesh, density, viscosity),
    U_(nullptr),
    liquids_(ratio_),
    interface_
    (
        membrane_.history(),
        membrane_.basis(),
        directions,
        mesh,
        ratio_ < 1 ? 1 : -1
    ),
    contrast_(interface_, liquids_),
    inertia_(membrane_.history(), interface_, liquids_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::sharpMembrane::setOuter(const immersedBody& outer)
{
    immersedMembrane::setOuter(outer);
    liquids_ = liquids(ratio_);
    interface_.setFitSide(ratio_ < 1 ? 1 : -1);
}


void Foam::capsule::sharpMembrane::start(const volVectorField& U)
{
    U_ = &U;
    setLiquids();
    interfaceState& now = membrane_.now();
    interface_.start(unsteady(), around_.mu());
    setScale();
    if (membrane_.nOld() == 0)
    {
        if (inertia_.unknown())
        {
            // No boundary layers yet
            now.inertia = -inertia_.viscousForce(now);
            interface_.setJumps(now, around_.mu());
        }
        // No velocity yet but that of the initial field
        now.velocity = fit()(U, nullptr).value;
    }
}


void Foam::capsule::sharpMembrane::predict
(
    const closedSurface& predicted,
    const couplingMethod& method
)
{
    setLiquids();
    addMomentum();
    interface_.advance(predicted, unsteady(), around_.mu());
    setFlowScheme();
    fluid_ = oneSidedFit::fitted();

    setScale();
    inertia_.advance();
    setMotion(predicted, method);
    if (liquids_.contrast())
    {
        membrane_.now().inertia = inertia_.value(flowScheme(), excess());
    }
}


void Foam::capsule::sharpMembrane::setJacobians(const couplingMethod& method)
{
    addProfiling(jacobians, "capsule::sharpMembrane::setJacobians");

    setResponse
    (
        method,
        contrast_.fluidJacobian(method.usesResponse()),
        freeSpaceResponse::singleLayer(surface(), around_.mu())
    );
}


Foam::capsule::nodalMatrix
Foam::capsule::sharpMembrane::unresolvedResponse() const
{
    const nodalScalars rest =
        basis().pack(membrane_.now().force - resolvedForce());

    nodalMatrix result(rest.size(), liquids_.contrast() ? 2 : 1);
    result.col(0) = mobility()*rest;
    if (liquids_.contrast())
    {
        result.col(1) = contrast_.traction(rest);
    }
    return result;
}


void Foam::capsule::sharpMembrane::restore()
{
    interface_.restore(around_.mu());
    immersedMembrane::restore();
}


Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::unknowns() const
{
    const nodalScalars f = immersedMembrane::unknowns();
    if (!inertia_.unknown())
    {
        return f;
    }
    nodalScalars result(2*f.size());
    result << f, inertia_.unknowns(membrane_.now());
    return result;
}


void Foam::capsule::sharpMembrane::setUnknowns(const nodalScalars& x)
{
    immersedMembrane::setUnknowns(x);
    if (inertia_.unknown())
    {
        inertia_.setUnknowns(x.tail(nForce()), membrane_.now());
    }
}


void Foam::capsule::sharpMembrane::addSources
(
    flowEquations::sources& sources,
    const surfaceScalarField* flux,
    const volScalarField& scale
)
{
    addProfiling(jumps, "capsule::sharpMembrane::addSources");

    const nodalVectors f = resolvedForce();
    const nodalVectors& m = membrane_.now().inertia;
    const bool first = (fluid_.value.rows() == 0);
    if (!flux || first)
    {
        interface_.setJumps(f, m, nodalScalars::Zero(membrane_.size()), around_.mu());
    }
    if (flux)
    {
        if (first)
        {
            fluid_ = fit()(*U_, nullptr);
        }
        interface_.setJumps(f, m, inertia_.pressureLaplacian(fluid_), around_.mu());
        interface_.addConvection
        (
            *flux, around_.rho()/around_.scale(), scale, sources.momentum
        );
    }

    const solvedVector resultant = surface().resultant(f);
    interface_.addSources
    (
        sources,
        around_.mu(),
        liquids_.scaling.viscousScale(),
        inertia_.unknown() ? nullptr : &resultant
    );
}


// ************************************************************************* //
