/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "forceMode.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(forceMode, 0);
    addToRunTimeSelectionTable(analyticalSolution, forceMode, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::forceMode::forceMode
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    polarSolution(dict, directions, viscosity, density),
    m_(dict.getCheck<label>("mode", labelMinMax::ge(2))),
    amplitude_(dict.get<scalar>("normal"), dict.get<scalar>("tangential"))
{
    const scalar m = m_;
    const scalar power[4] = {m, m + 2, -m, 2 - m};
    const scalar p[4] = {0, 4*(m + 1), 0, 4*(m - 1)};
    Eigen::Matrix4d system;
    for (label i = 0; i < 4; ++i)
    {
        // At r = R: u_r = m, u_theta = -e, du_r/dr = m (e - 1)/R,
        // du_theta/dr = -e (e - 1)/R for psi = R (r/R)^e sin(m theta)
        const scalar e = power[i];
        const scalar side = (i < 2 ? -1 : 1);
        const scalar stress =
            (i < 2 ? -viscosity_.first() : viscosity_.second())/radius_;
        system(0, i) = side*m;
        system(1, i) = -side*e;
        system(2, i) = stress*(-p[i] + 2*m*(e - 1));
        system(3, i) = stress*(-e*(e - 1) + e - sqr(m));
    }
    c_ = system.partialPivLu().solve
    (
        Eigen::Vector4d(0, 0, -amplitude_(0), -amplitude_(1))
    );
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::polarSolution::polarFlow
Foam::capsule::analyticalSolutions::forceMode::flow
(
    const scalar r,
    const scalar theta,
    const scalar,
    const bool in
) const
{
    const scalar m = m_;
    const scalar s = r/radius_;
    const scalar e0 = in ? m : -m;
    const scalar e1 = in ? m + 2 : 2 - m;
    const scalar c0 = in ? c_(0) : c_(2);
    const scalar c1 = in ? c_(1) : c_(3);
    const scalar psi = c0*std::pow(s, e0) + c1*std::pow(s, e1);
    const scalar slope =
        c0*e0*std::pow(s, e0 - 1) + c1*e1*std::pow(s, e1 - 1);
    const scalar p =
        in
      ? 4*viscosity_.first()*(m + 1)*std::pow(s, m)
      : 4*viscosity_.second()*(m - 1)*std::pow(s, -m);
    return
    {
        m*psi/s*std::cos(m*theta),
        -slope*std::sin(m*theta),
        p*c1/radius_*std::cos(m*theta)
    };
}


Foam::capsule::vector2
Foam::capsule::analyticalSolutions::forceMode::polarForce
(
    const scalar theta,
    const scalar
) const
{
    return vector2
    (
        amplitude_(0)*std::cos(m_*theta),
        amplitude_(1)*std::sin(m_*theta)
    );
}
