/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "immersedMembrane.H"
#include "freeSpaceResponse.H"
#include "timeScheme.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Vectors with their components stacked, and back
static nodalScalars stacked(const nodalVectors& v)
{
    return Eigen::Map<const nodalScalars>(v.data(), v.size());
}

static nodalVectors unstacked(const nodalScalars& v)
{
    return Eigen::Map<const nodalVectors>(v.data(), v.size()/2, 2);
}

//- Root mean square over the nodes
static scalar rms(const nodalVectors& v)
{
    return v.norm()/Foam::sqrt(scalar(v.rows()));
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::immersedMembrane::forceWaves_ = 1.0;
const Foam::scalar Foam::capsule::immersedMembrane::shapeWaves_ = 1.6;
const Foam::scalar Foam::capsule::immersedMembrane::motionWaves_ = 3;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::immersedInterface* Foam::capsule::immersedMembrane::placed
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


Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::filter
(
    const closedCurve& curve,
    const scalar waves
) const
{
    return curve.basis().lowPass
    (
        waves*curve.perimeter()
       /(constant::mathematical::twoPi*interface_->distance().width())
    );
}


Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::resolved
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


void Foam::capsule::immersedMembrane::setJumps
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
            mu_,
            smoothness()
        )
    );
}


void Foam::capsule::immersedMembrane::setResponse(const couplingMethod& method)
{
    const closedCurve& curve = interface_->distance().curve();
    const label n = 2*curve.size();
    const timeScheme scheme(mesh_, "ddt(membranes)", body_.nOld());

    resolving_ = filter(curve, forceWaves_);
    moving_ = filter(curve, motionWaves_);
    velocity_ = freeSpaceResponse::velocity(curve, mu_);

    nodalMatrix derivative = 0.5*(1 + ratio_)*nodalMatrix::Identity(n, n);
    if (ratio_ != 1)
    {
        traction_ = freeSpaceResponse::traction(curve);
        if (method.usesResponse())
        {
            derivative -= (1 - ratio_)*traction_;
        }
    }
    if (method.usesResponse() && method.implicitStress())
    {
        nodalMatrix displacement(n, n);
        displacement << moving_*velocity_.topRows(n/2),
            moving_*velocity_.bottomRows(n/2);
        derivative -= body_.forceJacobian(curve)*displacement/scheme.c;
    }
    balance_.compute(derivative);
}


void Foam::capsule::immersedMembrane::move
(
    const nodalVectors& U,
    const bool conserveArea
)
{
    const closedCurve& curve = interface_->distance().curve();
    const timeScheme scheme(mesh_, "ddt(membranes)", body_.nOld());
    membrane::state& now = body_.now();

    now.velocity = moving_*U;
    if (conserveArea)
    {
        // The net flux through the membrane that interpolation makes
        const scalar flux =
            curve.integral(dot(now.velocity, curve.normal()));
        now.velocity -= flux/curve.perimeter()*curve.normal();
    }

    now.x = scheme.c0*body_.old(0).x + now.velocity;
    if (scheme.c00 != 0)
    {
        now.x -= scheme.c00*body_.old(1).x;
    }
    now.x /= scheme.c;

    if (conserveArea)
    {
        // What the time scheme leaves
        const closedCurve moved(body_.basis(), now.x);
        now.x +=
            (body_.referenceArea() - moved.area())/moved.perimeter()
           *moved.normal();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::immersedMembrane::immersedMembrane
(
    const word& name,
    const dictionary& dict,
    const meshPlane& plane,
    const fvMesh& mesh,
    const scalar density,
    const scalar viscosity
)
:
    mesh_(mesh),
    plane_(plane),
    rho_(density),
    mu_(viscosity),
    body_(name, dict, plane, mesh),
    ratio_(body_.viscosity()/viscosity),
    warned_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::immersedMembrane::start(const volVectorField& U)
{
    membrane::state& now = body_.now();
    interface_.reset(placed(now.interface));
    setJumps(*interface_, now);
    fit_.reset(new oneSidedFit(*interface_, fitSide()));

    if (body_.nOld() > 0)
    {
        old_[0].reset(placed(body_.old(0).interface));
        setJumps(*old_[0], body_.old(0));
    }
    else
    {
        // No velocity yet but that of the initial field
        now.velocity = (*fit_)(U, nullptr).value;
    }
}


Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::predicted
(
    const scalar dt,
    const scalar dt0
) const
{
    const membrane::state& now = body_.now();

    return
        body_.nOld() == 0
      ? nodalVectors(now.x + dt*now.velocity)
      : nodalVectors(now.x + dt/dt0*(now.x - body_.old(0).x));
}


void Foam::capsule::immersedMembrane::predict(const couplingMethod& method)
{
    const scalar dt = mesh_.time().deltaTValue();
    const scalar dt0 = mesh_.time().deltaT0Value();

    const closedCurve ahead(body_.basis(), predicted(dt, dt0));
    const nodalVectors nodes = filter(ahead, shapeWaves_)*ahead.nodes();
    body_.store();

    old_[1].reset(old_[0].release());
    old_[0].reset(interface_.release());
    interface_.reset(placed(nodes));
    fit_.reset(new oneSidedFit(*interface_, fitSide()));

    membrane::state& now = body_.now();
    now.interface = nodes;
    now.x = nodes;
    if (body_.nOld() == 2)
    {
        now.force += dt/dt0*(body_.old(0).force - body_.old(1).force);
        now.velocity +=
            dt/dt0*(body_.old(0).velocity - body_.old(1).velocity);
    }
    const closedCurve& curve = interface_->distance().curve();
    explicitForce_ = body_.force(ahead, curve.metric());
    setResponse(method);

    if (ratio_ != 1)
    {
        now.inertia = resolved(curve, resolving_, inertia());
        if (ratio_ < 1 && viscousNumber(body_.viscosity()) < 0.3 && !warned_)
        {
            WarningInFunction
                << "Membrane " << body_.name() << ": the steps are so short"
                << " that the liquid inside has boundary layers thinner than"
                << " the cells: mu_in dt/(rho h^2) = "
                << viscousNumber(body_.viscosity()) << ", and below 0.3 the"
                << " run may become unstable. Larger steps or finer cells"
                << " help." << endl;
            warned_ = true;
        }
    }
}


Foam::capsule::nodalScalars Foam::capsule::immersedMembrane::force() const
{
    return stacked(body_.now().force);
}


void Foam::capsule::immersedMembrane::setForce(const nodalScalars& f)
{
    body_.now().force = unstacked(f);
}


void Foam::capsule::immersedMembrane::addSources
(
    flowEquations::sources& sources,
    const surfaceScalarField* flux,
    const volScalarField& scale
)
{
    const closedCurve& curve = interface_->distance().curve();
    const nodalVectors f = resolved(curve, resolving_, body_.now().force);
    interface_->setJumps
    (
        jumpConditions(curve, f, body_.now().inertia, mu_, smoothness())
    );
    if (flux)
    {
        interface_->addConvection(*flux, rho_, scale, sources.momentum);
    }
    const vector found =
        interface_->addLaplacian(mu_, sources.momentum)
      - interface_->addGradient(sources.gradient);
    interface_->addFlux(sources.flux, sources.pressureFlux);
    interface_->addDivergence(sources.divergence);

    // Momentum is conserved only to the order of the jumps: what is missing of
    // the membrane's resultant would show as noise of the pressure drop
    const vector resultant = plane_.thickness()*plane_.toVector
    (
        vector2(curve.integral(f.col(0)), curve.integral(f.col(1)))
    );
    interface_->addForce(resultant - found, sources.momentum);
}


Foam::capsule::immersedMembrane::correction
Foam::capsule::immersedMembrane::correct
(
    const volVectorField& U,
    const volScalarField& p,
    const couplingMethod& method,
    const bool conserveArea
)
{
    const closedCurve& curve = interface_->distance().curve();
    const membrane::state& now = body_.now();
    const bool contrast = (ratio_ != 1);

    const oneSidedFit::fitted fluid = (*fit_)(U, contrast ? &p : nullptr);
    const nodalScalars unresolved =
        stacked(now.force - resolved(curve, resolving_, now.force));

    move
    (
        fluid.value.leftCols(2) + unstacked(velocity_*unresolved),
        conserveArea
    );

    // Balance of stress at the points moved
    const nodalVectors F =
        method.implicitStress()
      ? body_.force(body_.curve(), curve.metric())
      : explicitForce_;
    nodalVectors balance = F - now.force;
    if (contrast)
    {
        // Inner traction; seen from outside, less by the force
        nodalVectors traction =
            fluid.traction(curve.normal(), mu_)
          + unstacked(traction_*unresolved - 0.5*fitSide()*unresolved);
        if (fitSide() > 0)
        {
            traction += now.force;
        }

        // The resultant is known: the rate of momentum of the liquid inside
        const vector2 excess =
            vector2
            (
                curve.integral(traction.col(0)),
                curve.integral(traction.col(1))
            )
          - momentumRate();
        traction.rowwise() -= excess/curve.perimeter();

        balance += (1 - ratio_)*traction;
    }

    const timeScheme scheme(mesh_, "ddt(membranes)", body_.nOld());
    const scalar size =
        rms(F) + 0.5*(1 + ratio_)*mu_*rms(curve.ds(now.velocity)) + VSMALL;
    correction result;
    result.force = balance_.solve(stacked(balance));
    result.stress = rms(unstacked(result.force))/size;
    result.displacement =
        unstacked(velocity_*result.force).rowwise().norm().maxCoeff()
       /(scheme.c*interface_->distance().width());
    return result;
}


void Foam::capsule::immersedMembrane::write() const
{
    body_.write(mesh_.time());
    body_.writeCloud(mesh_);
    interface_->distance().field()().write();
}
