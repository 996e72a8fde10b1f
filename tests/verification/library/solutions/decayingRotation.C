/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "decayingRotation.H"
#include "addToRunTimeSelectionTable.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(decayingRotation, 0);
    addToRunTimeSelectionTable(analyticalSolution, decayingRotation, dictionary);
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::analyticalSolutions::decayingRotation::rotation
(
    const scalar r,
    const bool in
) const
{
    return
        in
      ? A_*::j1(k_.first()*r)
      : B_*::j1(k_.second()*r) + C_*::y1(k_.second()*r);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::decayingRotation::decayingRotation
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    polarSolution(dict, directions, viscosity, density),
    rate_(dict.get<scalar>("rate")),
    normal_(dict.get<scalar>("normal")),
    k_
    (
        Foam::sqrt(rate_*density/viscosity.first()),
        Foam::sqrt(rate_*density/viscosity.second())
    ),
    C_(dict.get<scalar>("Y1"))
{
    A_ = 1/::j1(k_.first()*radius_);
    B_ = (1 - C_*::y1(k_.second()*radius_))/::j1(k_.second()*radius_);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::polarSolution::polarFlow
Foam::capsule::analyticalSolutions::decayingRotation::flow
(
    const scalar r,
    const scalar,
    const scalar t,
    const bool in
) const
{
    // Pressure from dp/dr = rho u_theta^2/r, by Simpson's rule from the circle
    const label n = 64;
    const scalar h = (r - radius_)/n;
    scalar p = 0;
    for (label i = 0; i <= n; ++i)
    {
        const scalar s = max(radius_ + i*h, ROOTVSMALL);
        const scalar weight = (i == 0 || i == n) ? 1 : (i % 2 ? 4 : 2);
        p += weight*h/3*density_*sqr(rotation(s, in))/s;
    }
    const scalar decay = std::exp(-rate_*t);
    return
    {
        0, decay*rotation(r, in), sqr(decay)*p - (in ? normal_ : 0)
    };
}


Foam::capsule::vector2
Foam::capsule::analyticalSolutions::decayingRotation::polarForce
(
    const scalar,
    const scalar t
) const
{
    // mu r d(u_theta/r)/dr = -mu k times the functions of order 2
    const scalar x = k_.second()*radius_;
    const scalar outer =
       -viscosity_.second()*k_.second()*(B_*::jn(2, x) + C_*::yn(2, x));
    const scalar inner =
       -viscosity_.first()*k_.first()*A_*::jn(2, k_.first()*radius_);
    return vector2(normal_, (inner - outer)*std::exp(-rate_*t));
}
