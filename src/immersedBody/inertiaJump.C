/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "inertiaJump.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::inertiaJump::relaxedForce
(
    const nodalScalars& df
) const
{
    const closedSurface& surface = interface_.surface();
    const nodalVectors f =
        interface_.resolved(surface.basis().unpack(df));
    const nodalVectors along = interface_.filtered
    (
        surface.gradient(dot(f, surface.normal()))
    );
    return
        interface_.levelSet().width()*(1 - liquids_.scaling.relaxation())
       *packed(along);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::inertiaJump::viscousForce
(
    const interfaceState& s
) const
{
    const closedSurface at(interface_.surface().basis(), s.interface);
    const nodalVectors f = interface_.resolved(at, s);

    return at.gradient(dot(f, at.normal())) + at.tangential(s.inertia);
}


void Foam::capsule::inertiaJump::advance()
{
    if (unknown())
    {
        oldViscousForce_ = viscousForce(history_.old(0));
    }
}


Foam::capsule::nodalVectors Foam::capsule::inertiaJump::value
(
    const timeScheme& scheme,
    const nodalVectors& excess
) const
{
    const closedSurface& surface = interface_.surface();
    const momentumScaling& scaling = liquids_.scaling;
    const interfaceState& now = history_.now();

    nodalVectors force =
        scheme.c*now.velocity - scheme.c0*history_.old(0).velocity;
    if (scheme.c00 != 0)
    {
        force += scheme.c00*history_.old(1).velocity;
    }
    if (scheme.c != 0 && excess.size())
    {
        // The points pass along the fluid: Du/Dt = du/dt - w.grad u
        force -= surface.along(excess, now.velocity);
    }
    force *= liquids_.density;

    const nodalScalars normal =
        (1 - scaling.viscousScale())*surface.divergence(now.vorticity)
      + (1 - scaling.scale())*dot(force, surface.normal());
    nodalVectors tangential =
        (scaling.scale() - 1/liquids_.ratio)*surface.gradient(now.pressure)
      + (1 - 1/liquids_.ratio)*surface.tangential(force);
    if (scaling.inertial())
    {
        const nodalVectors f = interface_.resolved(now.force);
        const nodalVectors along =
            surface.gradient(dot(f, surface.normal()));
        const scalar a = scaling.relaxation();
        tangential = a*tangential + (1 - a)*(oldViscousForce_ - along);
    }
    return interface_.filtered
    (
        scaled(normal, surface.normal()) + tangential
    );
}


Foam::capsule::nodalScalars Foam::capsule::inertiaJump::pressureLaplacian
(
    const oneSidedFit::fitted& fluid
) const
{
    const closedSurface& surface = interface_.surface();

    const nodalScalars jump = interface_.gradientProductJump
    (
        interface_.resolved(history_.now().force),
        history_.now().velocity,
        liquids_.viscosity
    );
    nodalScalars fitted = nodalScalars::Zero(surface.size());
    for (label i = 0; i < surface.nComponents(); ++i)
    {
        for (label j = 0; j < surface.nComponents(); ++j)
        {
            fitted += fluid.gradient[i].col(j).cwiseProduct
            (
                fluid.gradient[j].col(i)
            );
        }
    }
    if (surface.axisymmetric())
    {
        fitted += fluid.hoopRate.cwiseAbs2();
    }

    const nodalScalars inside =
        interface_.fitSide() > 0 ? nodalScalars(fitted - jump) : fitted;
    return -liquids_.density*((1 - liquids_.scaling.scale())*inside + jump);
}


Foam::capsule::solvedVector Foam::capsule::inertiaJump::momentumRate
(
    const timeScheme& scheme
) const
{
    const surfaceBasis& basis = interface_.surface().basis();
    const auto flow = [&](const interfaceState& s)
    {
        return closedSurface(basis, s.x).flow(s.velocity);
    };

    solvedVector rate = solvedVector::Zero(basis.nComponents());
    if (scheme.c != 0)
    {
        rate = scheme.c*flow(history_.now()) - scheme.c0*flow(history_.old(0));
    }
    if (scheme.c00 != 0)
    {
        rate += scheme.c00*flow(history_.old(1));
    }
    return liquids_.density*rate;
}


// ************************************************************************* //
