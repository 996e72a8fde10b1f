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
    static scalar rms(const nodalMatrix& v)
    {
        return v.norm()/Foam::sqrt(scalar(v.rows()));
    }
}
}

const Foam::scalar Foam::capsule::immersedMembrane::maxMove_ = 2;

const Foam::Enum<Foam::capsule::immersedMembrane::levelSetWritten>
Foam::capsule::immersedMembrane::levelSetNames_
({
    { levelSetWritten::none, "none" },
    { levelSetWritten::near, "near" },
    { levelSetWritten::whole, "whole" },
});


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalFilter Foam::capsule::immersedMembrane::filter
(
    const closedSurface& surface,
    const scalar waves
) const
{
    return surface.basis().lowPass
    (
        waves*surface.meanRadius()/levelSet().width()
    );
}


void Foam::capsule::immersedMembrane::setFlowScheme()
{
    flowScheme_.reset(new timeScheme(mesh_, "ddt(U)", membrane_.nOld()));
}


Foam::capsule::closedSurface
Foam::capsule::immersedMembrane::predictedSurface() const
{
    return closedSurface
    (
        membrane_.basis(),
        predicted(mesh_.time().deltaTValue(), mesh_.time().deltaT0Value())
    );
}


void Foam::capsule::immersedMembrane::extrapolateState(const nodalVectors& nodes)
{
    if (layer_.valid())
    {
        layer_->add(membrane_, mesh_.time().deltaT0Value());
    }
    membrane_.store();

    membrane::state& now = membrane_.now();
    now.interface = nodes;
    now.x = nodes;
    if (membrane_.nOld() == 2)
    {
        const scalar ratio =
            mesh_.time().deltaTValue()/mesh_.time().deltaT0Value();
        const membrane::state& old = membrane_.old(0);
        const membrane::state& older = membrane_.old(1);

        now.force += ratio*(old.force - older.force);
        now.velocity += ratio*(old.velocity - older.velocity);
        now.vorticity += ratio*(old.vorticity - older.vorticity);
        now.pressure += ratio*(old.pressure - older.pressure);
    }
    setFlowScheme();
}


Foam::scalar Foam::capsule::immersedMembrane::forceNoise
(
    const closedSurface& at
) const
{
    // A wave from point to point, along and across the membrane, small against
    // the distance of the points
    const scalar height = 1e-4*at.meanRadius()*basis().spacing();
    nodalVectors x(at.nodes());
    x.colwise() += height*basis().shortestWave();
    x = basis().symmetric(x);
    const nodalVectors change =
        membrane_.force(closedSurface(membrane_.basis(), x), at.areaElement())
      - membrane_.force(at, at.areaElement());

    return SMALL*at.nodes().cwiseAbs().maxCoeff()/height*rms(change);
}


Foam::capsule::timeScheme
Foam::capsule::immersedMembrane::setMembraneScheme()
{
    const timeScheme scheme(mesh_, "ddt(membranes)", membrane_.nOld());
    membrane_.setRates(scheme);
    return scheme;
}


void Foam::capsule::immersedMembrane::setResponse
(
    const closedSurface& predictedCurve,
    const couplingMethod& method,
    const nodalMatrix& fluidJacobian,
    const nodalMatrix& mobility
)
{
    motion_.reset
    (
        new membraneMotion
        (
            membrane_,
            surface(),
            predictedCurve,
            filter(surface(), membraneMotion::waves),
            setMembraneScheme(),
            method.conserveArea()
        )
    );
    implicit_ = method.implicitStress();
    explicitForce_ = membrane_.force(predictedCurve, surface().areaElement());
    forceNoise_ = forceNoise(predictedCurve);
    fluidJacobian_ = fluidJacobian;
    mobility_ = mobility;
    if (implicit_ && method.usesResponse())
    {
        displacementResponse_ = motion_->displacements(mobility_);
        linearise(surface(), false);
    }
    else
    {
        derivative_.compute(fluidJacobian_);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::immersedMembrane::immersedMembrane
(
    const word& name,
    const dictionary& dict,
    const solvedDirections& directions,
    const fvMesh& mesh,
    const scalar density,
    const scalar viscosity
)
:
    levelSet_(levelSetWritten::near),
    forceNoise_(0),
    implicit_(true),
    mesh_(mesh),
    directions_(directions),
    rho_(density),
    mu_(viscosity),
    membrane_(name, dict, directions, mesh),
    ratio_(membrane_.viscosity()/viscosity)
{
    setFlowScheme();
    setMembraneScheme();
    if (flowScheme().c != 0)
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
    const solvedDirections& directions,
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
    return cstrIter()(name, dict, directions, mesh, density, viscosity);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::predicted
(
    const scalar dt,
    const scalar dt0
) const
{
    const membrane::state& now = membrane_.now();

    if (membrane_.nOld() > 0)
    {
        return now.x + dt/dt0*(now.x - membrane_.old(0).x);
    }
    nodalVectors velocity = now.velocity;
    const nodalVectors w = membraneMotion::excess
    (
        membrane_, membrane_.surface(), velocity, 0.25/dt
    );
    if (w.size())
    {
        velocity += w;
    }
    return now.x + dt*velocity;
}


void Foam::capsule::immersedMembrane::restore()
{
    membrane_.restore();
    setFlowScheme();
    setMembraneScheme();
    // Its curve goes with the interface
    motion_.clear();
}


Foam::capsule::nodalScalars Foam::capsule::immersedMembrane::unknowns() const
{
    return basis().pack(membrane_.now().force);
}


void Foam::capsule::immersedMembrane::setUnknowns(const nodalScalars& x)
{
    membrane_.now().force = basis().unpack(x.head(nForce()));
}


Foam::capsule::immersedMembrane::imbalance
Foam::capsule::immersedMembrane::correct
(
    const volVectorField& U,
    const volScalarField& p,
    const solvedVector& driving
)
{
    const label n = nForce();
    membrane::state& now = membrane_.now();

    const nodalVectors fluid = velocity(U, p);
    now.velocity = motion_->velocity(fluid);
    now.x = motion_->points(now.velocity);

    const nodalVectors contrast = contrastTraction(driving);
    const nodalVectors rest = contrast - now.force;
    const nodalScalars other = inertiaResidual();
    fluidResponse_.resize(2*n + other.size());
    fluidResponse_ << basis().pack(fluid), basis().pack(rest), other;

    const nodalScalars left = residual(fluidResponse_);
    const nodalVectors F = basis().unpack(left.head(n)) - rest;
    const scalar size =
        rms(F)
      + 0.5*(1 + ratio_)*mu_*rms(surface().gradients(now.velocity)) + VSMALL;
    const nodalScalars change = correction(left);

    const scalar shear = (1 + ratio_)*mu_*rms(now.velocity)/levelSet().width();
    const scalar noise =
        10*forceNoise_ + 100*SMALL*(rms(now.force) + rms(contrast) + shear);

    imbalance result;
    const scalar rmsChange =
        change.norm()
       /Foam::sqrt(change.size()/scalar(basis().nComponents()));
    result.stress = max(rmsChange - noise, scalar(0))/size;
    result.displacement = cells(mobility_*change.head(n));
    return result;
}


Foam::scalar Foam::capsule::immersedMembrane::offset() const
{
    const membrane::state& now = membrane_.now();

    return
        (now.x - now.interface).rowwise().norm().maxCoeff()
       /levelSet().width();
}


Foam::scalar Foam::capsule::immersedMembrane::momentumThickness() const
{
    const scalar width = levelSet().width();

    return
        layer_.valid()
      ? layer_->thickness(membrane_, min(ratio_, scalar(1))*mu_/rho_, width)/width
      : GREAT;
}


void Foam::capsule::immersedMembrane::write() const
{
    membrane_.write(mesh_.time());
    membrane_.writeCloud(mesh_);
    if (levelSet_ == levelSetWritten::near)
    {
        levelSet().near()().write();
    }
    else if (levelSet_ == levelSetWritten::whole)
    {
        levelSet().whole()().write();
    }
}
