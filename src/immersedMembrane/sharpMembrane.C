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

const Foam::scalar Foam::capsule::sharpMembrane::forceWaves_ = 1.0;
const Foam::scalar Foam::capsule::sharpMembrane::shapeWaves_ = 1.6;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::immersedInterface* Foam::capsule::sharpMembrane::makeInterface
(
    const nodalVectors& nodes
) const
{
    return new immersedInterface
    (
        membrane_.name(),
        mesh_,
        directions_,
        closedSurface(membrane_.basis(), nodes),
        oneSidedFit::radius
    );
}


Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::resolved
(
    const closedSurface& surface,
    const nodalFilter& filter,
    const nodalVectors& f
)
{
    nodalVectors result = surface.filtered(filter, f);
    if (surface.axisymmetric() || surface.spatial())
    {
        // The rest has no resultant, or it would not fade; a smooth pressure
        // takes it
        result += scaled
        (
            surface.pressureOf(surface.resultant(f - result)), surface.normal()
        );
    }
    return result;
}


Foam::capsule::nodalVectors
Foam::capsule::sharpMembrane::resolvedForce() const
{
    return resolved(surface(), resolving_, membrane_.now().force);
}


Foam::capsule::nodalScalars
Foam::capsule::sharpMembrane::unresolvedForce() const
{
    return basis().pack(membrane_.now().force - resolvedForce());
}


void Foam::capsule::sharpMembrane::setJumps
(
    immersedInterface& interface,
    const membrane::state& s
)
{
    const closedSurface& at = interface.levelSet().surface();
    const nodalFilter passed = filter(at, forceWaves_);

    interface.setJumps
    (
        jumpConditions
        (
            at,
            resolved(at, passed, s.force),
            s.inertia,
            nodalScalars::Zero(membrane_.size()),
            mu_
        )
    );
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::velocity
(
    const volVectorField& U,
    const volScalarField& p
)
{
    fluid_ = (*fit_)(U, ratio_ != 1 ? &p : nullptr);

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
    U_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::sharpMembrane::start(const volVectorField& U)
{
    U_ = &U;
    membrane::state& now = membrane_.now();
    interface_.reset(makeInterface(now.interface));
    setScale();
    if (membrane_.nOld() == 0 && scaling_.inertial())
    {
        // No boundary layers yet
        now.inertia = -viscousForce(now);
    }
    setJumps(*interface_, now);
    fit_.reset(new oneSidedFit(*interface_, fitSide()));

    if (membrane_.nOld() == 0)
    {
        // No velocity yet but that of the initial field
        now.velocity = (*fit_)(U, nullptr).value;
    }
    else if (unsteady())
    {
        old_[0].reset(makeInterface(membrane_.old(0).interface));
        setJumps(*old_[0], membrane_.old(0));
    }
}


void Foam::capsule::sharpMembrane::predict(const couplingMethod& method)
{
    const closedSurface predictedCurve(predictedSurface());
    const nodalVectors nodes = filter(predictedCurve, shapeWaves_)*predictedCurve.nodes();
    extrapolateState(nodes);

    if (unsteady())
    {
        old_[1].reset(old_[0].release());
        old_[0].reset(interface_.release());
    }
    interface_.reset(makeInterface(nodes));
    fit_.reset(new oneSidedFit(*interface_, fitSide()));
    if (old_[0].valid())
    {
        // As a restart has them, without the Laplacian of the pressure
        setJumps(*old_[0], membrane_.old(0));
    }
    fluid_ = oneSidedFit::fitted();

    setScale();
    if (scaling_.inertial())
    {
        oldViscousForce_ = viscousForce(membrane_.old(0));
    }
    resolving_ = filter(surface(), forceWaves_);
    setResponse
    (
        predictedCurve,
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

    if (old_[0].valid())
    {
        interface_.reset(old_[0].release());
        old_[0].reset(old_[1].release());
    }
    else
    {
        // Not kept in Stokes flow
        interface_.reset(makeInterface(membrane_.now().interface));
        setJumps(*interface_, membrane_.now());
    }
    fit_.reset(new oneSidedFit(*interface_, fitSide()));
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
    const auto setJumps = [&](const nodalScalars& pressureLaplacian)
    {
        interface_->setJumps
        (
            jumpConditions
            (
                surface(),
                f,
                membrane_.now().inertia,
                pressureLaplacian,
                mu_
            )
        );
    };
    if (!flux || fluid_.value.rows() == 0)
    {
        setJumps(nodalScalars::Zero(membrane_.size()));
    }
    if (flux)
    {
        if (fluid_.value.rows() == 0)
        {
            fluid_ = (*fit_)(*U_, nullptr);
        }
        setJumps(pressureLaplacian());
    }
    if (flux)
    {
        interface_->addConvection(*flux, rho_, scale, sources.momentum);
    }
    const vector found =
        interface_->addLaplacian(mu_, scaling_.viscousScale(), sources.momentum)
      - interface_->addGradient(sources.gradient);
    interface_->addFlux(sources.flux, sources.pressureFlux);
    interface_->addInterpolationDivergence(sources.divergence);

    if (!scaling_.inertial())
    {
        // Momentum is conserved only to the order of the jumps: what is
        // missing of the membrane's resultant would show as noise of the
        // pressure drop
        const vector resultant =
            directions_.sector()*directions_.toVector(surface().resultant(f));
        interface_->addForce
        (
            resultant - directions_.conserved(found), sources.momentum
        );
    }
}
