/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sharpMembrane.H"
#include "timeScheme.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::viscousForce
(
    const interfaceState& s
) const
{
    const closedSurface at(membrane_.basis(), s.interface);
    const nodalVectors f = interface_.resolved(at, s);

    return at.gradient(dot(f, at.normal())) + at.tangential(s.inertia);
}


void Foam::capsule::sharpMembrane::setScale()
{
    if (ratio_ != 1)
    {
        const scalar inertia =
            rho_*flowScheme().c*sqr(levelSet().width());
        scaling_ = momentumScaling(ratio_, inertia > 0 ? mu_/inertia : GREAT);
    }
}


Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::inertia() const
{
    const timeScheme& scheme = flowScheme();
    const interfaceState& now = membrane_.now();

    nodalVectors force =
        scheme.c*now.velocity - scheme.c0*membrane_.old(0).velocity;
    if (scheme.c00 != 0)
    {
        force += scheme.c00*membrane_.old(1).velocity;
    }
    if (scheme.c != 0 && excess().size())
    {
        // The points pass along the fluid: Du/Dt = du/dt - w.grad u
        force -= surface().along(excess(), now.velocity);
    }
    force *= rho_;

    const nodalScalars normal =
        (1 - scaling_.viscousScale())*surface().divergence(now.vorticity)
      + (1 - scaling_.scale())*dot(force, surface().normal());
    nodalVectors tangential =
        (scaling_.scale() - 1/ratio_)*surface().gradient(now.pressure)
      + (1 - 1/ratio_)*surface().tangential(force);
    if (scaling_.inertial())
    {
        const nodalVectors along =
            surface().gradient(dot(resolvedForce(), surface().normal()));
        const scalar a = scaling_.relaxation();
        tangential = a*tangential + (1 - a)*(oldViscousForce_ - along);
    }
    return interface_.filtered
    (
        scaled(normal, surface().normal()) + tangential
    );
}


Foam::capsule::nodalScalars
Foam::capsule::sharpMembrane::pressureLaplacian() const
{
    // The gradient jumps by n b with b along the surface, its product with
    // itself by 2 n.(b.grad u)
    const nodalVectors b = -surface().tangential(resolvedForce())/mu_;
    const nodalScalars jump =
        2*dot
        (
            surface().along(b, membrane_.now().velocity), surface().normal()
        );
    nodalScalars fitted = nodalScalars::Zero(surface().size());
    for (label i = 0; i < surface().nComponents(); ++i)
    {
        for (label j = 0; j < surface().nComponents(); ++j)
        {
            fitted += fluid_.gradient[i].col(j).cwiseProduct
            (
                fluid_.gradient[j].col(i)
            );
        }
    }
    if (surface().axisymmetric())
    {
        fitted += fluid_.hoopRate.cwiseAbs2();
    }

    const nodalScalars inside =
        interface_.fitSide() > 0 ? nodalScalars(fitted - jump) : fitted;
    return -rho_*((1 - scaling_.scale())*inside + jump);
}


Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::relaxedForce
(
    const nodalScalars& df
) const
{
    const nodalVectors f = interface_.resolved(basis().unpack(df));
    const nodalVectors along = interface_.filtered
    (
        surface().gradient(dot(f, surface().normal()))
    );
    return
        levelSet().width()*(1 - scaling_.relaxation())*basis().pack(along);
}


Foam::capsule::solvedVector
Foam::capsule::sharpMembrane::momentumRate() const
{
    const timeScheme& scheme = flowScheme();

    const auto flow = [&](const interfaceState& s)
    {
        return closedSurface(basis(), s.x).flow(s.velocity);
    };

    solvedVector rate = solvedVector::Zero(basis().nComponents());
    if (scheme.c != 0)
    {
        rate = scheme.c*flow(membrane_.now()) - scheme.c0*flow(membrane_.old(0));
    }
    if (scheme.c00 != 0)
    {
        rate += scheme.c00*flow(membrane_.old(1));
    }
    return rho_*rate;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::inertiaResidual() const
{
    if (!scaling_.inertial())
    {
        return nodalScalars(0);
    }
    return levelSet().width()*basis().pack(inertia() - membrane_.now().inertia);
}


Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::inertiaCorrection
(
    const nodalScalars& df,
    const nodalScalars& residual
) const
{
    return residual/(1 + scaling_.feedback()) - relaxedForce(df);
}


Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::inertiaResidualChange
(
    const nodalScalars& dx
) const
{
    if (!scaling_.inertial())
    {
        return nodalScalars(0);
    }
    const label n = dx.size()/2;
    return -(1 + scaling_.feedback())*(dx.tail(n) + relaxedForce(dx.head(n)));
}


// ************************************************************************* //
