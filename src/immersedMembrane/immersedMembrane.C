/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "immersedMembrane.H"
#include "timeScheme.H"
#include "input.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(immersedMembrane, 0);
    defineRunTimeSelectionTable(immersedMembrane, dictionary);

    //- Root mean square over the nodes
    static scalar rms(const nodalVectors& v)
    {
        return v.norm()/Foam::sqrt(scalar(v.rows()));
    }
}
}

const Foam::scalar Foam::capsule::immersedMembrane::reach_ = 2;

const Foam::Enum<Foam::capsule::immersedMembrane::levelSetWritten>
Foam::capsule::immersedMembrane::levelSetNames_
({
    { levelSetWritten::none, "none" },
    { levelSetWritten::near, "near" },
    { levelSetWritten::whole, "whole" },
});


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::filter
(
    const closedCurve& curve,
    const scalar waves
) const
{
    return curve.basis().lowPass
    (
        waves*curve.perimeter()
       /(constant::mathematical::twoPi*distance().width())
    );
}


Foam::capsule::closedCurve Foam::capsule::immersedMembrane::ahead() const
{
    return closedCurve
    (
        body_.basis(),
        predicted(mesh_.time().deltaTValue(), mesh_.time().deltaT0Value())
    );
}


void Foam::capsule::immersedMembrane::advance(const nodalVectors& nodes)
{
    if (layer_.valid())
    {
        layer_->add(body_, mesh_.time().deltaT0Value());
    }
    body_.store();

    membrane::state& now = body_.now();
    now.interface = nodes;
    now.x = nodes;
    if (body_.nOld() == 2)
    {
        const scalar ratio =
            mesh_.time().deltaTValue()/mesh_.time().deltaT0Value();
        const membrane::state& old = body_.old(0);
        const membrane::state& older = body_.old(1);

        now.force += ratio*(old.force - older.force);
        now.velocity += ratio*(old.velocity - older.velocity);
        now.inner += ratio*(old.inner - older.inner);
    }
}


Foam::scalar Foam::capsule::immersedMembrane::forceNoise
(
    const closedCurve& curve
) const
{
    // A wave from point to point, along and across the membrane, small against
    // the distance of the points
    const scalar height = 1e-4*curve.perimeter()/body_.size();
    nodalVectors x(curve.nodes());
    for (Eigen::Index i = 0; i < x.rows(); ++i)
    {
        x.row(i).array() += (i % 2 ? -height : height);
    }
    const nodalVectors change =
        body_.force(closedCurve(body_.basis(), x), curve.metric())
      - body_.force(curve, curve.metric());

    return SMALL*curve.nodes().cwiseAbs().maxCoeff()/height*rms(change);
}


void Foam::capsule::immersedMembrane::setResponse
(
    const closedCurve& ahead,
    const couplingMethod& method,
    const nodalMatrix& fluid,
    const nodalMatrix& velocity
)
{
    motion_.reset
    (
        new membraneMotion
        (
            body_,
            curve(),
            ahead,
            filter(curve(), membraneMotion::waves),
            timeScheme(mesh_, "ddt(membranes)", body_.nOld()),
            method.conserveArea()
        )
    );
    implicit_ = method.implicitStress();
    explicitForce_ = body_.force(ahead, curve().metric());
    forceNoise_ = forceNoise(ahead);
    fluid_ = fluid;
    velocity_ = velocity;
    if (implicit_ && method.usesResponse())
    {
        displacement_ = motion_->displacements(velocity_);
        linearise(curve(), false);
    }
    else
    {
        derivative_.compute(fluid_);
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
    levelSet_(levelSetWritten::near),
    forceNoise_(0),
    implicit_(true),
    mesh_(mesh),
    plane_(plane),
    rho_(density),
    mu_(viscosity),
    body_(name, dict, plane, mesh),
    ratio_(body_.viscosity()/viscosity)
{
    if (timeScheme(mesh_, "ddt(U)", 0).c != 0)
    {
        layer_.reset(new momentumLayer);
    }
    if (dict.found("levelSet"))
    {
        const word name(input::get<word>(dict, "levelSet"));
        if (!levelSetNames_.found(name))
        {
            FatalIOErrorInFunction(dict)
                << "Entry levelSet is " << name << "; permitted: "
                << flatOutput(levelSetNames_.toc()) << exit(FatalIOError);
        }
        levelSet_ = levelSetNames_[name];
    }
}


Foam::autoPtr<Foam::capsule::immersedMembrane>
Foam::capsule::immersedMembrane::New
(
    const dictionary& coupling,
    const word& name,
    const dictionary& dict,
    const meshPlane& plane,
    const fvMesh& mesh,
    const scalar density,
    const scalar viscosity
)
{
    const word type(input::getOrDefault<word>(coupling, "interface", "sharp"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            coupling,
            "interface",
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return cstrIter()(name, dict, plane, mesh, density, viscosity);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::predicted
(
    const scalar dt,
    const scalar dt0
) const
{
    const membrane::state& now = body_.now();

    if (body_.nOld() > 0)
    {
        return now.x + dt/dt0*(now.x - body_.old(0).x);
    }
    nodalVectors velocity = now.velocity;
    const closedCurve curve = body_.curve();
    const nodalScalars w =
        membraneMotion::excess(body_, curve, velocity, 0.25/dt);
    if (w.size())
    {
        velocity += scaled(w, curve.tangent());
    }
    return now.x + dt*velocity;
}


void Foam::capsule::immersedMembrane::restore()
{
    body_.restore();

    // Its curve goes with the interface
    motion_.clear();
}


Foam::capsule::nodalScalars Foam::capsule::immersedMembrane::unknowns() const
{
    return stacked(body_.now().force);
}


void Foam::capsule::immersedMembrane::setUnknowns(const nodalScalars& x)
{
    body_.now().force = unstacked(x.head(2*body_.size()));
}


Foam::capsule::immersedMembrane::correction
Foam::capsule::immersedMembrane::correct
(
    const volVectorField& U,
    const volScalarField& p,
    const vector2& driving
)
{
    const label n = body_.size();
    membrane::state& now = body_.now();

    const nodalVectors fluid = velocity(U, p);
    now.velocity = motion_->velocity(fluid);
    now.x = motion_->points(now.velocity);

    const nodalVectors contrast = contrastForce(driving);
    const nodalVectors rest = contrast - now.force;
    const nodalScalars other = otherBalance();
    answer_.resize(4*n + other.size());
    answer_ << stacked(fluid), stacked(rest), other;

    const nodalScalars imbalance = balance(answer_);
    const nodalVectors F = unstacked(imbalance.head(2*n)) - rest;
    const scalar size =
        rms(F) + 0.5*(1 + ratio_)*mu_*rms(curve().ds(now.velocity)) + VSMALL;
    const nodalScalars change = step(imbalance);

    const scalar shear = (1 + ratio_)*mu_*rms(now.velocity)/distance().width();
    const scalar noise =
        10*forceNoise_ + 100*SMALL*(rms(now.force) + rms(contrast) + shear);

    correction result;
    result.stress = max(rms(unstacked(change)) - noise, scalar(0))/size;
    result.displacement = cells(velocity_*change.head(2*n));
    return result;
}


Foam::scalar Foam::capsule::immersedMembrane::offset() const
{
    const membrane::state& now = body_.now();

    return
        (now.x - now.interface).rowwise().norm().maxCoeff()
       /distance().width();
}


Foam::scalar Foam::capsule::immersedMembrane::momentumThickness() const
{
    const scalar width = distance().width();

    return
        layer_.valid()
      ? layer_->thickness(body_, min(ratio_, scalar(1))*mu_/rho_, width)/width
      : GREAT;
}


void Foam::capsule::immersedMembrane::write() const
{
    body_.write(mesh_.time());
    body_.writeCloud(mesh_);
    if (levelSet_ == levelSetWritten::near)
    {
        distance().near()().write();
    }
    else if (levelSet_ == levelSetWritten::whole)
    {
        distance().whole()().write();
    }
}
