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
}
}

const Foam::scalar Foam::capsule::immersedMembrane::maxMove_ = 2;


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::capsule::immersedMembrane::extrapolateState(const nodalVectors& nodes)
{
    if (layer_.valid())
    {
        layer_->add(membrane_, mesh_.time().deltaT0Value());
    }
    membrane_.history().advance(nodes, mesh_.time());
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

    return outerScale()*SMALL*at.nodes().cwiseAbs().maxCoeff()/height*rms(change);
}


Foam::capsule::timeScheme
Foam::capsule::immersedMembrane::setMembraneScheme()
{
    const timeScheme scheme(mesh_, "ddt(membranes)", membrane_.nOld());
    membrane_.setRates(scheme);
    return scheme;
}


void Foam::capsule::immersedMembrane::setMotion
(
    const closedSurface& predictedCurve,
    const couplingMethod& method
)
{
    motion_.reset
    (
        new membraneMotion
        (
            membrane_,
            surface(),
            predictedCurve,
            levelSet().filter(surface(), membraneMotion::waves),
            setMembraneScheme(),
            method.conserveArea()
        )
    );
    predictedPoints_ = predictedCurve.nodes();
    implicit_ = method.implicitStress();
}


void Foam::capsule::immersedMembrane::setResponse
(
    const couplingMethod& method,
    const nodalMatrix& fluidJacobian,
    const nodalMatrix& mobility
)
{
    const closedSurface predictedCurve(basis(), predictedPoints_);
    explicitForce_ = force(predictedCurve);
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
    immersedBody(dict, directions, mesh, density, viscosity),
    forceNoise_(0),
    implicit_(true),
    noise_(0),
    membrane_(name, dict, directions, mesh),
    ratio_(membrane_.viscosity()/viscosity)
{
    setFlowScheme();
    setMembraneScheme();
    if (flowScheme().c != 0)
    {
        layer_.reset(new momentumLayer);
    }
}


Foam::autoPtr<Foam::capsule::immersedBody>
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
    return autoPtr<immersedBody>
    (
        cstrIter()(name, dict, directions, mesh, density, viscosity).ptr()
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::immersedMembrane::setOuter(const immersedBody& outer)
{
    immersedBody::setOuter(outer);
    ratio_ = membrane_.viscosity()/outerViscosity();
}


Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::predicted
(
    const scalar dt,
    const scalar dt0
) const
{
    const interfaceState& now = membrane_.now();

    if (membrane_.nOld() > 0)
    {
        const interfaceState& old = membrane_.old(0);
        nodalVectors x = now.x + dt/dt0*(now.x - old.x);
        if (membrane_.nOld() > 1 && !unsteady())
        {
            // Along their curved paths
            x += 0.5*dt*(1 + dt/dt0)*(now.velocity - old.velocity);
        }
        return x;
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
    membrane_.history().restore();
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


void Foam::capsule::immersedMembrane::correct
(
    const volVectorField& U,
    const volScalarField& p,
    const solvedVector& driving
)
{
    const label n = nForce();
    interfaceState& now = membrane_.now();

    const nodalVectors fluid = velocity(U, p);
    now.velocity = motion_->velocity(fluid);
    now.x = motion_->points(now.velocity);

    const nodalVectors contrast = contrastTraction(driving);
    const nodalVectors rest = contrast - now.force;
    const nodalScalars other = inertiaResidual();
    fluidResponse_.resize(2*n + other.size());
    fluidResponse_ << basis().pack(fluid), basis().pack(rest), other;

    const scalar shear = (1 + ratio_)*mu_*rms(now.velocity)/levelSet().width();
    noise_ = 10*forceNoise_ + 100*SMALL*(rms(now.force) + rms(contrast) + shear);
}


Foam::capsule::immersedMembrane::imbalance
Foam::capsule::immersedMembrane::remaining
(
    const nodalScalars& residual,
    const nodalScalars& change
) const
{
    const label n = nForce();
    const nodalScalars rest = fluidResponse_.segment(n, n);
    const nodalVectors F = basis().unpack(residual.head(n) - rest);
    const scalar size =
        rms(F)
      + 0.5*(1 + ratio_)*mu_*rms(surface().gradients(history().now().velocity))
      + VSMALL;

    imbalance result;
    const scalar rmsChange =
        change.norm()
       /Foam::sqrt(change.size()/scalar(basis().nComponents()));
    result.stress = max(rmsChange - noise_, scalar(0))/size;
    result.displacement = cells(mobility_*change.head(n));
    return result;
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
    immersedBody::write();
    membrane_.writeCloud(mesh_);
}


// ************************************************************************* //
