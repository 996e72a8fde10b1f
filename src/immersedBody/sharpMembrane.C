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

Foam::capsule::nodalScalars
Foam::capsule::sharpMembrane::unresolvedForce() const
{
    return basis().pack(membrane_.now().force - resolvedForce());
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::velocity
(
    const volVectorField& U,
    const volScalarField& p
)
{
    fluid_ = fit()(U, ratio_ != 1 ? &p : nullptr);

    return
        fluid_.value.leftCols(basis().nComponents())
      + basis().unpack(mobility()*unresolvedForce());
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
    scaling_(ratio_),
    U_(nullptr),
    interface_
    (
        membrane_.history(),
        membrane_.basis(),
        directions,
        mesh,
        ratio_ < 1 ? 1 : -1
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::sharpMembrane::setOuter(const immersedBody& outer)
{
    immersedMembrane::setOuter(outer);
    scaling_ = momentumScaling(ratio_);
    interface_.setFitSide(ratio_ < 1 ? 1 : -1);
}


void Foam::capsule::sharpMembrane::start(const volVectorField& U)
{
    U_ = &U;
    setSurroundings();
    interfaceState& now = membrane_.now();
    interface_.start(unsteady(), mu_);
    setScale();
    if (membrane_.nOld() == 0)
    {
        if (scaling_.inertial())
        {
            // No boundary layers yet
            now.inertia = -viscousForce(now);
            interface_.setJumps(now, mu_);
        }
        // No velocity yet but that of the initial field
        now.velocity = fit()(U, nullptr).value;
    }
}


void Foam::capsule::sharpMembrane::predict(const couplingMethod& method)
{
    setSurroundings();
    const closedSurface predicted(predictedSurface());
    extrapolateState(interface_.smoothed(predicted));
    interface_.advance(unsteady(), mu_);
    fluid_ = oneSidedFit::fitted();

    setScale();
    if (scaling_.inertial())
    {
        oldViscousForce_ = viscousForce(membrane_.old(0));
    }
    setResponse
    (
        predicted,
        method,
        fluidDerivative(method),
        freeSpaceResponse::singleLayer(surface(), mu_)
    );
    if (ratio_ != 1)
    {
        membrane_.now().inertia = inertia();
    }
}


void Foam::capsule::sharpMembrane::restore()
{
    immersedMembrane::restore();
    interface_.restore(mu_);
}


Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::unknowns() const
{
    const nodalScalars f = immersedMembrane::unknowns();
    if (!scaling_.inertial())
    {
        return f;
    }
    nodalScalars result(2*f.size());
    result << f, levelSet().width()*basis().pack(membrane_.now().inertia);
    return result;
}


void Foam::capsule::sharpMembrane::setUnknowns(const nodalScalars& x)
{
    immersedMembrane::setUnknowns(x);
    if (scaling_.inertial())
    {
        membrane_.now().inertia =
            basis().unpack(x.tail(nForce())/levelSet().width());
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
        interface_.setJumps(f, m, nodalScalars::Zero(membrane_.size()), mu_);
    }
    if (flux)
    {
        if (first)
        {
            fluid_ = fit()(*U_, nullptr);
        }
        interface_.setJumps(f, m, pressureLaplacian(), mu_);
        interface_.addConvection
        (
            *flux, rho_/outerScale(), scale, sources.momentum
        );
    }

    const solvedVector resultant = surface().resultant(f);
    interface_.addSources
    (
        sources,
        mu_,
        scaling_.viscousScale(),
        scaling_.inertial() ? nullptr : &resultant
    );
}


// ************************************************************************* //
