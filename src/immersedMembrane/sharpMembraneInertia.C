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

Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::viscousForce
(
    const membrane::state& s
) const
{
    const closedSurface curve(membrane_.basis(), s.interface);
    const nodalVectors f =
        resolved(curve, filter(curve, forceWaves_), s.force);

    return
        curve.ds(dot(f, curve.normal())) + dot(s.inertia, curve.tangent());
}


void Foam::capsule::sharpMembrane::setScale()
{
    if (ratio_ != 1)
    {
        const scalar inertia =
            rho_*flowScheme().c*sqr(interface_->levelSet().width());
        scaling_ = momentumScaling(ratio_, inertia > 0 ? mu_/inertia : GREAT);
    }
}


Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::inertia() const
{
    const timeScheme& scheme = flowScheme();
    const membrane::state& now = membrane_.now();

    nodalVectors force =
        scheme.c*now.velocity - scheme.c0*membrane_.old(0).velocity;
    if (scheme.c00 != 0)
    {
        force += scheme.c00*membrane_.old(1).velocity;
    }
    if (scheme.c != 0 && excess().size())
    {
        // The points pass along the fluid: Du/Dt = du/dt - w du/ds
        force -= scaled(excess(), curve().ds(now.velocity));
    }
    force *= rho_;

    const nodalScalars vorticity = now.inner.col(0);
    const nodalScalars pressure = now.inner.col(1);
    const nodalScalars normal =
        (1 - scaling_.viscousScale())*curve().divergence(vorticity)
      + (1 - scaling_.scale())*dot(force, curve().normal());
    nodalScalars tangential =
        (scaling_.scale() - 1/ratio_)*curve().ds(pressure)
      + (1 - 1/ratio_)*dot(force, curve().tangent());
    if (scaling_.inertial())
    {
        const nodalScalars along =
            curve().ds(dot(resolvedForce(), curve().normal()));
        const scalar a = scaling_.relaxation();
        tangential = a*tangential + (1 - a)*(oldViscousForce_ - along);
    }

    return
        scaled(resolving_*normal, curve().normal())
      + scaled(resolving_*tangential, curve().tangent());
}


Foam::capsule::nodalScalars
Foam::capsule::sharpMembrane::pressureLaplacian() const
{
    const auto times = [](const nodalScalars& a, const nodalScalars& b)
    {
        return nodalScalars(a.cwiseProduct(b));
    };
    const nodalMatrix& x = fluid_.gradient[0];
    const nodalMatrix& y = fluid_.gradient[1];

    // The gradient jumps by n b t, its product with itself by 2 b U_s.n
    const nodalScalars b = -dot(resolvedForce(), curve().tangent())/mu_;
    const nodalVectors along = curve().ds(membrane_.now().velocity);
    const nodalScalars jump = 2*times(b, dot(along, curve().normal()));
    nodalScalars fitted =
        times(x.col(0), x.col(0)) + times(y.col(1), y.col(1))
      + 2*times(x.col(1), y.col(0));
    if (curve().axisymmetric())
    {
        fitted += fluid_.hoopRate.cwiseAbs2();
    }

    const nodalScalars inside =
        fitSide() > 0 ? nodalScalars(fitted - jump) : fitted;
    return -rho_*((1 - scaling_.scale())*inside + jump);
}


Foam::capsule::nodalScalars Foam::capsule::sharpMembrane::relaxedForce
(
    const nodalScalars& df
) const
{
    const nodalVectors f = resolved(curve(), resolving_, basis().unpack(df));
    const nodalScalars along =
        resolving_*curve().ds(dot(f, curve().normal()));

    return
        levelSet().width()*(1 - scaling_.relaxation())
       *basis().pack(scaled(along, curve().tangent()));
}


Foam::capsule::vector2 Foam::capsule::sharpMembrane::momentumRate() const
{
    const timeScheme& scheme = flowScheme();

    const auto flow = [&](const membrane::state& s)
    {
        return closedSurface(basis(), s.x).flow(s.velocity);
    };

    vector2 rate = vector2::Zero();
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::sharpMembrane::addFreshCells(volVectorField& ddtU) const
{
    const timeScheme& scheme = flowScheme();
    const scalar weights[2] = {scheme.c0, -scheme.c00};
    const membraneLevelSet& present = interface_->levelSet();

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
