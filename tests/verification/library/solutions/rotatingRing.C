/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rotatingRing.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(rotatingRing, 0);
    addToRunTimeSelectionTable(analyticalSolution, rotatingRing, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::rotatingRing::rotatingRing
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    polarSolution(dict, directions, viscosity, density),
    W_(dict.get<scalar>("rate")),
    a_(0),
    b_(dict.get<scalar>("vortex"))
{
    a_ = W_ - b_/sqr(radius_);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::polarSolution::polarFlow
Foam::capsule::analyticalSolutions::rotatingRing::flow
(
    const scalar r,
    const scalar,
    const scalar,
    const bool in
) const
{
    // Pressure from dp/dr = rho u_theta^2/r, continuous
    const auto outside = [&](const scalar s)
    {
        return
            density_
           *(
                0.5*sqr(a_*s) + 2*a_*b_*std::log(s/radius_) - 0.5*sqr(b_/s)
            );
    };
    if (in)
    {
        const scalar p = 0.5*density_*sqr(W_)*(sqr(r) - sqr(radius_));
        return {0, W_*r, p};
    }
    return {0, a_*r + b_/r, outside(r) - outside(radius_)};
}


Foam::capsule::vector2
Foam::capsule::analyticalSolutions::rotatingRing::polarForce
(
    const scalar,
    const scalar
) const
{
    return vector2(0, 2*viscosity_.second()*b_/sqr(radius_));
}
