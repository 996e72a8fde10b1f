/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "nestedMode.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(nestedMode, 0);
    addToRunTimeSelectionTable(analyticalSolution, nestedMode, dictionary);
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::nestedMode::term
Foam::capsule::analyticalSolutions::nestedMode::termOf(const label i) const
{
    const scalar m = m_;
    const term terms[4] =
        {{m, 0}, {m + 2, 4*(m + 1)}, {-m, 0}, {2 - m, 4*(m - 1)}};
    return terms[i];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::nestedMode::nestedMode
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    polarSolution(dict, directions, viscosity, density),
    m_(dict.getCheck<label>("mode", labelMinMax::ge(2))),
    amplitude_(dict.get<scalar>("normal"), dict.get<scalar>("tangential")),
    coreRadius_(dict.get<scalar>("coreRadius")),
    coreViscosity_(dict.get<scalar>("coreViscosity"))
{
    // At r: u_r = m psi/r, u_theta = -psi', psi = R (r/R)^e sin(m theta)
    const scalar m = m_;
    Eigen::Matrix<scalar, 8, 8> system;
    system.setZero();
    const auto add = [&]
    (
        const label row,
        const label column,
        const label i,
        const scalar side,
        const scalar mu
    )
    {
        const scalar s = row == 0 ? coreRadius_/radius_ : 1;
        const term t = termOf(i);
        const scalar u = std::pow(s, t.e - 1);
        const scalar stress = side*mu*u/(s*radius_);
        system(row, column) = side*m*u;
        system(row + 1, column) = -side*t.e*u;
        system(row + 2, column) = stress*(-t.p + 2*m*(t.e - 1));
        system(row + 3, column) =
            stress*(-t.e*(t.e - 1) + t.e - sqr(m));
    };
    for (label i = 0; i < 4; ++i)
    {
        if (i < 2)
        {
            add(0, i, i, -1, coreViscosity_);
        }
        else
        {
            add(4, 4 + i, i, 1, viscosity_.second());
        }
        add(0, 2 + i, i, 1, viscosity_.first());
        add(4, 2 + i, i, -1, viscosity_.first());
    }
    Eigen::Matrix<scalar, 8, 1> force;
    force << 0, 0, 0, 0, 0, 0, -amplitude_(0), -amplitude_(1);
    c_ = system.partialPivLu().solve(force);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::polarSolution::polarFlow
Foam::capsule::analyticalSolutions::nestedMode::flow
(
    const scalar r,
    const scalar theta,
    const scalar,
    const bool in
) const
{
    const scalar m = m_;
    const scalar s = r/radius_;
    const bool core = in && r < coreRadius_;
    const scalar mu =
        core ? coreViscosity_ : in ? viscosity_.first() : viscosity_.second();
    const label start = core ? 0 : in ? 2 : 4;
    const label first = in ? 0 : 2;
    const label last = core ? 2 : 4;

    polarFlow result = {0, 0, 0};
    for (label i = first; i < last; ++i)
    {
        const term t = termOf(i);
        const scalar u = c_(start + i)*std::pow(s, t.e - 1);
        result.r += m*u*std::cos(m*theta);
        result.theta -= t.e*u*std::sin(m*theta);
        result.p += mu*t.p*u/(s*radius_)*std::cos(m*theta);
    }
    return result;
}


Foam::capsule::vector2
Foam::capsule::analyticalSolutions::nestedMode::polarForce
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
