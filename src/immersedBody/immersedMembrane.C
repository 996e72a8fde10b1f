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

void Foam::capsule::immersedMembrane::addMomentum()
{
    if (layer_.valid())
    {
        layer_->add(membrane_, mesh_.time().deltaT0Value());
    }
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
    noise_.setPoints(membrane_, predictedCurve, around_.scale());
    tangent_.setFluid(mobility, fluidJacobian);
    if (implicit_ && method.usesResponse())
    {
        tangent_.setDisplacements(motion_->displacements(mobility));
        linearise(surface(), false);
    }
    else
    {
        tangent_.linearise();
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
    implicit_(true),
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
    const auto& table = *dictionaryConstructorTablePtr_;
    const word entry("interface");
    const word type
    (
        coupling.found(entry)
      ? input::choice(coupling, entry, table.sortedToc())
      : word("sharp")
    );
    return autoPtr<immersedBody>
    (
        table[type](name, dict, directions, mesh, density, viscosity).ptr()
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::immersedMembrane::setOuter(const immersedBody& outer)
{
    immersedBody::setOuter(outer);
    ratio_ = membrane_.viscosity()/outerViscosity();
}


Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::predicted() const
{
    const Time& time = mesh_.time();

    return membraneMotion::predicted
    (
        membrane_, time.deltaTValue(), time.deltaT0Value(), unsteady()
    );
}


void Foam::capsule::immersedMembrane::restore()
{
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

    const scalar shear = (1 + ratio_)*around_.mu()*rms(now.velocity)/levelSet().width();
    noise_.setStresses(rms(now.force) + rms(contrast) + shear);
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
      + 0.5*(1 + ratio_)*around_.mu()*rms(surface().gradients(history().now().velocity))
      + VSMALL;

    imbalance result;
    const scalar rmsChange =
        change.norm()
       /Foam::sqrt(change.size()/scalar(basis().nComponents()));
    result.stress = max(rmsChange - noise_.value(), scalar(0))/size;
    result.displacement = cells(mobility()*change.head(n));
    return result;
}


Foam::scalar Foam::capsule::immersedMembrane::momentumThickness() const
{
    const scalar width = levelSet().width();

    return
        layer_.valid()
      ? layer_->thickness(membrane_, min(ratio_, scalar(1))*around_.mu()/around_.rho(), width)/width
      : GREAT;
}


void Foam::capsule::immersedMembrane::write() const
{
    immersedBody::write();
    membrane_.writeCloud(mesh_);
}


// ************************************************************************* //
