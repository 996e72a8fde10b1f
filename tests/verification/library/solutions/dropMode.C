/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "dropMode.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(dropMode, 0);
    addToRunTimeSelectionTable(analyticalSolution, dropMode, dictionary);
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::dropMode::number
Foam::capsule::analyticalSolutions::dropMode::I
(
    const label m,
    const number z
)
{
    // Periodic: converges faster than any power, once it resolves the waves
    const label n = 40 + label(std::abs(z));
    number sum = 0;
    for (label i = 0; i < 2*n; ++i)
    {
        const scalar angle = constant::mathematical::pi*i/n;
        sum +=
            std::exp(z*(std::cos(angle) - 1))*std::cos(scalar(m)*angle);
    }
    return sum/scalar(2*n);
}


Foam::capsule::analyticalSolutions::dropMode::number
Foam::capsule::analyticalSolutions::dropMode::K
(
    const label m,
    const number z
)
{
    const scalar h = 0.05;
    const scalar last = std::acosh(1 + 50/z.real());
    number sum = 0.5;
    for (scalar x = h; x < last; x += h)
    {
        sum += std::exp(z*(1 - std::cosh(x)))*std::cosh(m*x);
    }
    return h*sum;
}


Foam::capsule::analyticalSolutions::dropMode::number
Foam::capsule::analyticalSolutions::dropMode::waveNumber(const bool in) const
{
    const scalar mu = (in ? viscosity_.first() : viscosity_.second());
    return radius_*std::sqrt(rate_*density_/mu);
}


Foam::capsule::analyticalSolutions::dropMode::derivatives
Foam::capsule::analyticalSolutions::dropMode::potential
(
    const bool in,
    const scalar x
) const
{
    const scalar e = (in ? m_ : -m_);
    const scalar f = std::pow(x, e);
    return derivatives(f, e*f/x, e*(e - 1)*f/sqr(x));
}


Foam::capsule::analyticalSolutions::dropMode::derivatives
Foam::capsule::analyticalSolutions::dropMode::vortical
(
    const bool in,
    const scalar x
) const
{
    const number k = waveNumber(in);
    const auto bessel = [&](const label m)
    {
        return
            in
          ? I(m, k*x)*std::exp(k*(x - 1))
          : K(m, k*x)*std::exp(k*(1 - x));
    };

    // I' = (I_m-1 + I_m+1)/2, K' = -(K_m-1 + K_m+1)/2, and Bessel's equation
    const number at1 = in ? I(m_, k) : K(m_, k);
    const number f = bessel(m_)/at1;
    const number f1 =
        (in ? 0.5 : -0.5)*k*(bessel(m_ - 1) + bessel(m_ + 1))/at1;
    return derivatives(f, f1, (k*k + sqr(scalar(m_)/x))*f - f1/x);
}


Foam::capsule::analyticalSolutions::dropMode::number
Foam::capsule::analyticalSolutions::dropMode::imbalance(const number rate)
{
    rate_ = rate;
    const scalar m = m_;
    Eigen::Matrix<number, 4, 4> system = Eigen::Matrix<number, 4, 4>::Zero();
    Eigen::Matrix<number, 4, 1> normalStress;

    for (label i = 0; i < 4; ++i)
    {
        const bool in = (i < 2);
        const bool vortex = (i % 2);
        const scalar side = (in ? -1 : 1);
        const scalar mu = (in ? viscosity_.first() : viscosity_.second());
        const derivatives f = (vortex ? vortical(in, 1) : potential(in, 1));

        // u_r = m f/x cos, u_theta = -f' sin; the potential has a pressure
        const number p = (vortex ? 0 : side*density_*rate_*radius_);
        system(0, i) = side*f(0);
        system(1, i) = side*f(1);
        system(2, i) = side*mu*(f(1) - f(2) - sqr(m)*f(0));
        system(3, i) = (in ? m*f(0) : 0);
        normalStress(i) = side*(2*mu*m*(f(1) - f(0))/radius_ - p);
    }
    const number displacement = amplitude_*radius_;
    c_ = system.partialPivLu().solve
    (
        Eigen::Matrix<number, 4, 1>(0, 0, 0, rate_*displacement)
    );
    return
        normalStress.cwiseProduct(c_).sum()
      - tension_*(sqr(m) - 1)/sqr(radius_)*displacement;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::dropMode::dropMode
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    polarSolution(dict, directions, viscosity, density),
    m_(dict.getCheck<label>("mode", labelMinMax::ge(2))),
    amplitude_(dict.get<scalar>("amplitude")),
    tension_(dict.get<scalar>("tension"))
{
    const scalar m = m_;
    const scalar inviscid = std::sqrt
    (
        tension_*m*(sqr(m) - 1)/(2*density_*pow3(radius_))
    );
    number before(0, inviscid);
    number now(-0.05*inviscid, inviscid);
    number atBefore = imbalance(before);
    number atNow = imbalance(now);
    for (label i = 0; i < 100 && std::abs(now - before) > 1e-13*inviscid; ++i)
    {
        const number next = now - atNow*(now - before)/(atNow - atBefore);
        before = now;
        atBefore = atNow;
        now = next;
        atNow = imbalance(now);
    }
    if (!(now.real() < 0 && now.imag() > 0))
    {
        FatalIOErrorInFunction(dict)
            << "No damped oscillation of mode " << m_ << " is found; the"
            << " viscosities are too large for it" << exit(FatalIOError);
    }
    Info<< "Drop of mode " << m_ << ": damping " << -rate_.real()
        << ", frequency " << rate_.imag() << " 1/s" << endl;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::capsule::analyticalSolutions::dropMode::radius
(
    const scalar theta,
    const scalar t
) const
{
    const number growth = std::exp(rate_*t);
    return radius_*(1 + amplitude_*growth.real()*std::cos(m_*theta));
}


Foam::capsule::polarSolution::polarFlow
Foam::capsule::analyticalSolutions::dropMode::flow
(
    const scalar r,
    const scalar theta,
    const scalar t,
    const bool in
) const
{
    const number growth = std::exp(rate_*t);
    const scalar x = r/radius(theta, t);
    const label i = (in ? 0 : 2);
    const derivatives a = growth*c_(i)*potential(in, x);
    const derivatives b = growth*c_(i + 1)*vortical(in, x);
    const number p = (in ? -1 : 1)*density_*rate_*radius_*a(0);

    return
    {
        m_*(a(0) + b(0)).real()/x*std::cos(m_*theta),
        -(a(1) + b(1)).real()*std::sin(m_*theta),
        (in ? tension_/radius_ : 0) + p.real()*std::cos(m_*theta)
    };
}
