/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rigidBody.H"
#include "sourceMoment.H"
#include "placedShape.H"
#include "profiling.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(rigidBody, 0);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::timeScheme Foam::capsule::rigidBody::motionScheme() const
{
    return timeScheme(mesh_, "ddt(membranes)", history_.nOld());
}


Foam::capsule::rigidShape::place Foam::capsule::rigidBody::moved
(
    const nodalScalars& V
) const
{
    const timeScheme scheme = motionScheme();
    const rigidShape::place from = placeOf(history_.old(0));
    nodalScalars step = V;
    if (scheme.c00 != 0)
    {
        step += scheme.c00*shape_->displacement(placeOf(history_.old(1)), from);
    }
    return shape_->moved(from, step/scheme.c);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::rigidBody::rigidBody
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
    history_("body", name, directions),
    motion_
    (
        input::subDict(dict, "motion"), directions, mesh.time().value()
    )
{
    input::permit
    (
        dict, {"type", "shape", "motion", "points", "degree", "levelSet"}
    );
    input::choice(dict, "type", {typeName});

    placedShape placed(kind(), name, dict, directions, mesh);
    if (placed.shape().initialStretch() != 1)
    {
        FatalIOErrorInFunction(dict.subDict("shape"))
            << "Entry initialStretch is " << placed.shape().initialStretch()
            << "; permitted for a rigid body: none" << exit(FatalIOError);
    }
    basis_ = placed.basis();
    const closedSurface initial(*basis_, placed.nodes());
    shape_.reset(new rigidShape(initial));
    history_.now() = interfaceState::atRest
    (
        initial.nodes(), 0*initial.nodes()
    );
    if (!history_.read(dict.topDict(), mesh.time()))
    {
        Info<< "Body " << name << ": starts as "
            << placed.description().c_str() << endl;
    }

    interface_.reset
    (
        new sharpInterface(history_, *basis_, directions, mesh, 1)
    );
    inside_.reset
    (
        new displacedLiquid(*interface_, *shape_, directions, mesh)
    );
    setFlowScheme();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::rigidBody::velocity() const
{
    return velocityOf(history_.now());
}


void Foam::capsule::rigidBody::start(const volVectorField& U)
{
    around_.setStep();
    interface_->start(unsteady(), around_.mu());
    centre_ = surface().centroid();
    if (unsteady() && inside_->readRate(name(), taken_))
    {
        taken_ *= around_.scale();
    }
    if (history_.nOld() == 0)
    {
        // No velocity yet but that given, or that of the initial field
        interfaceState& now = history_.now();
        const nodalScalars V =
            motion_.free()
          ? shape_->velocityOf
            (
                now.x,
                centre_,
                fit()(U, nullptr).value.leftCols(basis_->nComponents())
            )
          : motion_.velocity(mesh_.time().value());
        now.velocity = shape_->velocity(now.x, centre_, V);
    }
}


Foam::capsule::nodalVectors Foam::capsule::rigidBody::predicted() const
{
    const scalar dt = mesh_.time().deltaTValue();

    // By Adams and Bashforth: the body turns while it is led on
    nodalScalars V = velocityOf(history_.now());
    if (history_.nOld() > 0)
    {
        V +=
            0.5*dt/mesh_.time().deltaT0Value()
           *(V - velocityOf(history_.old(0)));
    }
    return shape_->nodes(shape_->moved(place(), dt*V));
}


void Foam::capsule::rigidBody::predict
(
    const closedSurface& predicted,
    const couplingMethod&
)
{
    around_.setStep();
    interface_->advance(predicted, unsteady(), around_.mu());
    setFlowScheme();
    centre_ = surface().centroid();
    setResponse();
    if (unsteady())
    {
        inside_->advance(centre_);
    }
}


void Foam::capsule::rigidBody::restore()
{
    interface_->restore(around_.mu());
    setFlowScheme();
}


void Foam::capsule::rigidBody::setInside
(
    volVectorField& U,
    surfaceScalarField& phi
) const
{
    inside_->setRigid(place().centre, velocity(), U, phi);
}


void Foam::capsule::rigidBody::write() const
{
    immersedBody::write();
    if (unsteady())
    {
        inside_->writeRate(name(), taken_/around_.scale());
    }
}


void Foam::capsule::rigidBody::addFreshCells(volVectorField& ddtU) const
{
    interface_->addFreshCells(flowScheme(), ddtU);
}


void Foam::capsule::rigidBody::addGradient(volTensorField& gradient) const
{
    interface_->addGradient(gradient);
}


void Foam::capsule::rigidBody::addSources
(
    flowEquations::sources& sources,
    const surfaceScalarField* flux,
    const volScalarField& scale
)
{
    addProfiling(jumps, "capsule::rigidBody::addSources");

    const nodalVectors f = interface_->resolved(history_.now().force);
    interface_->setJumps
    (
        f,
        history_.now().inertia,
        flux
      ? nodalScalars
        (
           -around_.rho()*interface_->gradientProductJump
            (
                f, history_.now().velocity, around_.mu()
            )
        )
      : nodalScalars(nodalScalars::Zero(surface().size())),
        around_.mu()
    );
    if (flux)
    {
        interface_->addConvection
        (
            *flux, around_.rho()/around_.scale(), scale, sources.momentum
        );
    }
    sourceMoment moment(*interface_, directions_, sources);
    const solvedVector resultant = surface().resultant(f);
    interface_->addSources(sources, around_.mu(), 1, &resultant);
    if (surface().nRotations())
    {
        moment.correct(f, centre_);
    }
}


void Foam::capsule::rigidBody::correct
(
    const volVectorField& U,
    const volScalarField&,
    const solvedVector&
)
{
    const label n = nForce();
    const nodalVectors fluid =
        fit()(U, nullptr).value.leftCols(basis_->nComponents());
    const nodalScalars unresolved = basis_->pack
    (
        history_.now().force - interface_->resolved(history_.now().force)
    );
    fluidResponse_.resize(nResponse());
    fluidResponse_.head(2*n)
        << basis_->pack(fluid) + slip_.velocity()*unresolved,
        unknowns();
    const nodalScalars V = carried(fluidResponse_.head(n));
    if (unsteady())
    {
        const nodalScalars momentum = inside_->momentum(U);
        taken_ = around_.rho()*(flowScheme().c*momentum - oldMomentum());
        if (directions_.spatial())
        {
            taken_ +=
                around_.rho()
               *inside_->delayedRate(momentum, V, fluxVelocity());
        }
    }
    if (counted())
    {
        fluidResponse_.tail(taken_.size()) = taken_;
    }

    interfaceState& now = history_.now();
    const rigidShape::place to = moved(V);
    now.x = shape_->nodes(to);
    now.velocity = shape_->velocity(now.x, to.centre, V);
}


Foam::capsule::immersedBody::imbalance Foam::capsule::rigidBody::remaining
(
    const nodalScalars&,
    const nodalScalars& change
) const
{
    // What slips, without the net flux, and against the force that is
    // expected: a body starts with none
    const interfaceState& now = history_.now();
    const nodalVectors df = basis_->unpack(change);
    const nodalVectors slip = basis_->unpack(slip_.velocity()*change);
    const scalar width = levelSet().width();
    const scalar stress =
        rms(now.force + df) + around_.mu()*rms(surface().gradients(now.velocity))
      + VSMALL;
    const scalar noise =
        100*SMALL*(rms(now.force) + around_.mu()*rms(now.velocity)/width);

    imbalance result;
    result.stress = max(rms(df) - noise, scalar(0))/stress;
    result.displacement =
        slip.rowwise().norm().maxCoeff()/(motionScheme().c*width);
    return result;
}


// ************************************************************************* //
