/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sharpInterface.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::sharpInterface::forceWaves_ = 1.0;
const Foam::scalar Foam::capsule::sharpInterface::shapeWaves_ = 1.6;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::immersedInterface* Foam::capsule::sharpInterface::made
(
    const nodalVectors& nodes
) const
{
    return new immersedInterface
    (
        history_.name(),
        mesh_,
        directions_,
        closedSurface(basis_, nodes),
        oneSidedFit::radius
    );
}


Foam::capsule::nodalVectors Foam::capsule::sharpInterface::resolved
(
    const closedSurface& surface,
    const nodalFilter& passed,
    const nodalVectors& f
)
{
    nodalVectors result = surface.filtered(passed, f);
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


void Foam::capsule::sharpInterface::setJumps
(
    immersedInterface& interface,
    const interfaceState& s,
    const scalar mu
) const
{
    const closedSurface& at = interface.levelSet().surface();
    const nodalFilter passed = levelSet().filter(at, forceWaves_);

    interface.setJumps
    (
        jumpConditions
        (
            at,
            resolved(at, passed, s.force),
            s.inertia,
            nodalScalars::Zero(at.size()),
            mu
        )
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sharpInterface::sharpInterface
(
    interfaceHistory& history,
    const surfaceBasis& basis,
    const solvedDirections& directions,
    const fvMesh& mesh,
    const label fitSide
)
:
    history_(history),
    basis_(basis),
    directions_(directions),
    mesh_(mesh),
    fitSide_(fitSide)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::sharpInterface::start
(
    const bool unsteady,
    const scalar mu
)
{
    interface_.reset(made(history_.now().interface));
    setJumps(*interface_, history_.now(), mu);
    fit_.reset(new oneSidedFit(*interface_, fitSide_));
    if (unsteady && history_.nOld() > 0)
    {
        old_[0].reset(made(history_.old(0).interface));
        setJumps(*old_[0], history_.old(0), mu);
    }
}


void Foam::capsule::sharpInterface::advance
(
    const closedSurface& predicted,
    const bool unsteady,
    const scalar mu
)
{
    history_.advance
    (
        levelSet().filter(predicted, shapeWaves_)*predicted.nodes(),
        mesh_.time()
    );
    if (unsteady)
    {
        old_[1].reset(old_[0].release());
        old_[0].reset(interface_.release());
    }
    interface_.reset(made(history_.now().interface));
    fit_.reset(new oneSidedFit(*interface_, fitSide_));
    if (old_[0].valid())
    {
        // As a restart has them, without the Laplacian of the pressure
        setJumps(*old_[0], history_.old(0), mu);
    }
    resolving_ = levelSet().filter(surface(), forceWaves_);
}


void Foam::capsule::sharpInterface::restore(const scalar mu)
{
    history_.restore();
    if (old_[0].valid())
    {
        interface_.reset(old_[0].release());
        old_[0].reset(old_[1].release());
    }
    else
    {
        // Not kept in Stokes flow
        interface_.reset(made(history_.now().interface));
        setJumps(*interface_, history_.now(), mu);
    }
    fit_.reset(new oneSidedFit(*interface_, fitSide_));
}


Foam::capsule::nodalScalars
Foam::capsule::sharpInterface::gradientProductJump
(
    const nodalVectors& f,
    const nodalVectors& u,
    const scalar mu
) const
{
    const nodalVectors b = -surface().tangential(f)/mu;

    return 2*dot(surface().along(b, u), surface().normal());
}


void Foam::capsule::sharpInterface::setJumps
(
    const nodalVectors& f,
    const nodalVectors& inertia,
    const nodalScalars& pressureLaplacian,
    const scalar mu
)
{
    interface_->setJumps
    (
        jumpConditions(surface(), f, inertia, pressureLaplacian, mu)
    );
}


void Foam::capsule::sharpInterface::addSources
(
    flowEquations::sources& sources,
    const scalar mu,
    const scalar viscousScale,
    const solvedVector* resultant
) const
{
    const vector found =
        interface_->addLaplacian(mu, viscousScale, sources.momentum)
      - interface_->addGradient(sources.gradient);
    interface_->addFlux(sources.flux, sources.pressureFlux);
    interface_->addInterpolationDivergence(sources.divergence);

    if (resultant)
    {
        const vector wanted =
            directions_.sector()*directions_.toVector(*resultant);
        interface_->addForce
        (
            wanted - directions_.conserved(found), sources.momentum
        );
    }
}


void Foam::capsule::sharpInterface::addFreshCells
(
    const timeScheme& scheme,
    volVectorField& ddtU
) const
{
    const scalar weights[2] = {scheme.c0, -scheme.c00};
    const membraneLevelSet& present = levelSet();

    for (label level = 0; level < 2; ++level)
    {
        if (!old_[level].valid() || weights[level] == 0)
        {
            continue;
        }

        // The old value as the new side of the cell saw it
        const membraneLevelSet& old = old_[level]->levelSet();
        for (const label celli : present.inside())
        {
            if (!old.contains(celli))
            {
                ddtU[celli] -= weights[level]*old_[level]->jumpU(celli);
            }
        }
        for (const label celli : old.inside())
        {
            if (!present.contains(celli))
            {
                ddtU[celli] += weights[level]*old_[level]->jumpU(celli);
            }
        }
    }
}


// ************************************************************************* //
