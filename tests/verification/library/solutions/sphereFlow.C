/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphereFlow.H"
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::sphereFlow::sphereFlow
(
    const label degree,
    const scalar radius,
    const Pair<scalar>& viscosity,
    const amplitudes& force
)
:
    l_(degree),
    radius_(radius),
    viscosity_(viscosity),
    force_(force),
    velocity_{0, 0, 0, 0}
{
    if (l_ == 0)
    {
        return;
    }

    const scalar l = l_;
    const scalar s = l*(l + 1);
    const scalar in = viscosity_.first();
    const scalar out = viscosity_.second();
    const scalar det =
    (
        2*(l + 1)*(l - 1)*(2*sqr(l) + 4*l + 3)*sqr(in)
      + (8*sqr(s) - 4*s + 3)*in*out
      + 2*l*(l + 2)*(2*sqr(l) + 1)*sqr(out)
    )/s;
    const scalar both = 3*(in*(l + 1) + out*l);

    velocity_.U =
        radius_/det
       *((2*l + 1)*(in + out)*force_.normal + both*force_.tangential);
    velocity_.V =
        radius_/det
       *(
            both/s*force_.normal
          + (
                in*(2*sqr(l) + l + 3)/l + out*(2*sqr(l) + 3*l + 4)/(l + 1)
            )*force_.tangential
        );

    // Shear stress mu (dW/dR - W/R)
    velocity_.W = radius_*force_.swirl/(in*(l - 1) + out*(l + 2));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::sphereFlow::factors
Foam::capsule::analyticalSolutions::sphereFlow::operator()
(
    const scalar r,
    const bool in
) const
{
    if (l_ == 0)
    {
        return {0, 0, 0, in ? -force_.normal : 0};
    }

    const scalar l = l_;
    const scalar s = l*(l + 1);
    const scalar q = r/radius_;
    const scalar U = velocity_.U;
    const scalar V = velocity_.V;

    if (in)
    {
        const scalar A = (l + 1)*(l*V - U)/2;
        const scalar a = A*std::pow(q, l + 1);
        const scalar b = (U - A)*std::pow(q, l - 1);
        const scalar p = viscosity_.first()*(2*l + 3)*2*A/(l*radius_);
        return
        {
            a + b,
            a*(l + 3)/s + b/l,
            velocity_.W*std::pow(q, l),
            p*std::pow(q, l)
        };
    }
    const scalar C = l*((l + 1)*V + U)/2;
    const scalar c = C*std::pow(q, -l);
    const scalar d = (U - C)*std::pow(q, -l - 2);
    const scalar p = viscosity_.second()*(2*l - 1)*2*C/((l + 1)*radius_);
    return
    {
        c + d,
        c*(2 - l)/s - d/(l + 1),
        velocity_.W*std::pow(q, -l - 1),
        p*std::pow(q, -l - 1)
    };
}
