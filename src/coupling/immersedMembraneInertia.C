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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::immersedMembrane::viscousNumber
(
    const scalar viscosity
) const
{
    const scalar inertia =
        rho_*timeScheme(mesh_, "ddt(U)", body_.nOld()).c
       *sqr(interface_->distance().width());

    return inertia > 0 ? viscosity/inertia : GREAT;
}


Foam::scalar Foam::capsule::immersedMembrane::smoothness() const
{
    return
        ratio_ == 1
      ? 1
      : 1/(1 + sqr(0.5/viscousNumber(min(mu_, body_.viscosity()))));
}


Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::inertia() const
{
    const timeScheme scheme(mesh_, "ddt(U)", body_.nOld());

    nodalVectors acceleration =
        scheme.c*body_.now().velocity - scheme.c0*body_.old(0).velocity;
    if (scheme.c00 != 0)
    {
        acceleration += scheme.c00*body_.old(1).velocity;
    }
    return (1 - 1/ratio_)*rho_*acceleration;
}


Foam::capsule::vector2 Foam::capsule::immersedMembrane::momentumRate() const
{
    const timeScheme scheme(mesh_, "ddt(U)", body_.nOld());

    // Integral of the velocity over the area, by the divergence theorem
    const auto flow = [&](const membrane::state& s)
    {
        const closedCurve curve(body_.basis(), s.x);
        const nodalScalars un = dot(s.velocity, curve.normal());
        return vector2
        (
            curve.integral(s.x.col(0).cwiseProduct(un)),
            curve.integral(s.x.col(1).cwiseProduct(un))
        );
    };

    vector2 rate = vector2::Zero();
    if (scheme.c != 0)
    {
        rate = scheme.c*flow(body_.now()) - scheme.c0*flow(body_.old(0));
    }
    if (scheme.c00 != 0)
    {
        rate += scheme.c00*flow(body_.old(1));
    }
    return rho_/ratio_*rate;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::immersedMembrane::addSwept(volVectorField& ddtU) const
{
    const timeScheme scheme(mesh_, "ddt(U)", body_.nOld());
    const scalar weights[2] = {scheme.c0, -scheme.c00};
    const volScalarField& side = interface_->distance().side();

    for (label level = 0; level < 2; ++level)
    {
        if (!old_[level].valid() || weights[level] == 0)
        {
            continue;
        }

        // The old value as the new side of the cell saw it
        const volScalarField& oldSide = old_[level]->distance().side();
        const volVectorField& jump = old_[level]->jumpU();
        forAll(side, celli)
        {
            if (side[celli] != oldSide[celli])
            {
                ddtU[celli] += weights[level]*side[celli]*jump[celli];
            }
        }
    }
}
