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

Foam::capsule::immersedInterface* Foam::capsule::sharpMembrane::placed
(
    const nodalVectors& nodes
) const
{
    return new immersedInterface
    (
        body_.name(),
        mesh_,
        plane_,
        closedCurve(body_.basis(), nodes),
        oneSidedFit::radius
    );
}


Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::resolved
(
    const closedCurve& curve,
    const nodalMatrix& filter,
    const nodalVectors& f
)
{
    // Along normal and tangent, so that a uniform pressure is kept whole
    const nodalVectors& n = curve.normal();
    const nodalVectors& t = curve.tangent();

    return scaled(filter*dot(f, n), n) + scaled(filter*dot(f, t), t);
}


Foam::capsule::nodalVectors
Foam::capsule::sharpMembrane::resolvedForce() const
{
    return resolved(curve(), resolving_, body_.now().force);
}


Foam::capsule::nodalScalars
Foam::capsule::sharpMembrane::unresolvedForce() const
{
    return stacked(body_.now().force - resolvedForce());
}


void Foam::capsule::sharpMembrane::setJumps
(
    immersedInterface& interface,
    const membrane::state& s
)
{
    const closedCurve& curve = interface.distance().curve();
    const nodalMatrix passed = filter(curve, forceWaves_);

    interface.setJumps
    (
        jumpConditions
        (
            curve,
            resolved(curve, passed, s.force),
            s.inertia,
            nodalScalars::Zero(body_.size()),
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
        fluid_.value.leftCols(2)
      + unstacked(velocityResponse()*unresolvedForce());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sharpMembrane::sharpMembrane
(
    const word& name,
    const dictionary& dict,
    const meshPlane& plane,
    const fvMesh& mesh,
    const scalar density,
    const scalar viscosity
)
:
    immersedMembrane(name, dict, plane, mesh, density, viscosity),
    scale_(1/ratio_),
    viscousScale_(1),
    U_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::sharpMembrane::start(const volVectorField& U)
{
    U_ = &U;
    membrane::state& now = body_.now();
    interface_.reset(placed(now.interface));
    setScale();
    if (body_.nOld() == 0 && inertial())
    {
        // No boundary layers yet
        now.inertia = scaled(-viscousForce(now), curve().tangent());
    }
    setJumps(*interface_, now);
    fit_.reset(new oneSidedFit(*interface_, fitSide()));

    if (body_.nOld() == 0)
    {
        // No velocity yet but that of the initial field
        now.velocity = (*fit_)(U, nullptr).value;
    }
    else if (keepsInterfaces())
    {
        old_[0].reset(placed(body_.old(0).interface));
        setJumps(*old_[0], body_.old(0));
    }
}


void Foam::capsule::sharpMembrane::predict(const couplingMethod& method)
{
    const closedCurve predictedCurve(ahead());
    const nodalVectors nodes = filter(predictedCurve, shapeWaves_)*predictedCurve.nodes();
    advance(nodes);

    if (keepsInterfaces())
    {
        old_[1].reset(old_[0].release());
        old_[0].reset(interface_.release());
    }
    interface_.reset(placed(nodes));
    fit_.reset(new oneSidedFit(*interface_, fitSide()));
    if (old_[0].valid())
    {
        // As a restart has them, without the Laplacian of the pressure
        setJumps(*old_[0], body_.old(0));
    }
    fluid_ = oneSidedFit::fitted();

    setScale();
    if (inertial())
    {
        oldViscousForce_ = viscousForce(body_.old(0));
    }
    resolving_ = filter(curve(), forceWaves_);
    setResponse
    (
        predictedCurve,
        method,
        fluidDerivative(method),
        freeSpaceResponse::velocity(curve(), mu_)
    );
    if (ratio_ != 1)
    {
        body_.now().inertia = inertia();
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
        interface_.reset(placed(body_.now().interface));
        setJumps(*interface_, body_.now());
    }
    fit_.reset(new oneSidedFit(*interface_, fitSide()));
}


Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::unknowns() const
{
    const nodalScalars f = immersedMembrane::unknowns();
    if (!inertial())
    {
        return f;
    }
    nodalScalars result(2*f.size());
    result << f, distance().width()*stacked(body_.now().inertia);
    return result;
}


void Foam::capsule::sharpMembrane::setUnknowns(const nodalScalars& x)
{
    immersedMembrane::setUnknowns(x);
    if (inertial())
    {
        body_.now().inertia =
            unstacked(x.tail(2*body_.size())/distance().width());
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
                curve(),
                f,
                body_.now().inertia,
                pressureLaplacian,
                mu_
            )
        );
    };
    if (!flux || fluid_.value.rows() == 0)
    {
        setJumps(nodalScalars::Zero(body_.size()));
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
        interface_->addLaplacian(mu_, viscousScale_, sources.momentum)
      - interface_->addGradient(sources.gradient);
    interface_->addFlux(sources.flux, sources.pressureFlux);
    interface_->addDivergence(sources.divergence);

    if (!inertial())
    {
        // Momentum is conserved only to the order of the jumps: what is
        // missing of the membrane's resultant would show as noise of the
        // pressure drop
        const vector resultant = plane_.thickness()*plane_.toVector
        (
            vector2(curve().integral(f.col(0)), curve().integral(f.col(1)))
        );
        interface_->addForce(resultant - found, sources.momentum);
    }
}
