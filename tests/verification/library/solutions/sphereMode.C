/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphereMode.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(sphereMode, 0);
    addToRunTimeSelectionTable(analyticalSolution, sphereMode, dictionary);
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::vector2
Foam::capsule::analyticalSolutions::sphereMode::harmonic
(
    const scalar theta
) const
{
    // k P_k = (2k - 1) cos P_k-1 - (k - 1) P_k-2, and its derivative
    const scalar c = std::cos(theta);
    const scalar s = std::sin(theta);
    vector2 before(0, 0);
    vector2 now(1, 0);
    for (label k = 1; k <= l_; ++k)
    {
        const vector2 next
        (
            (2*k - 1)*c*now(0) - (k - 1)*before(0),
            (2*k - 1)*(c*now(1) - s*now(0)) - (k - 1)*before(1)
        );
        before = now;
        now = next/k;
    }
    return now;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::sphereMode::sphereMode
(
    const dictionary& dict,
    const solvedDirections& plane,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    analyticalSolution(dict, plane, viscosity, density),
    l_(dict.getCheck<label>("mode", labelMinMax::ge(0))),
    amplitude_(dict.get<scalar>("normal"), dict.get<scalar>("tangential")),
    velocity_(0, 0)
{
    const vector centre(dict.get<vector>("centre"));
    if
    (
        !plane.axisymmetric()
     || mag(plane.radius(plane(centre))) > 1e-9*radius_
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entry type: " << typeName << " needs a wedge with the entry"
            << " centre on its axis, not " << centre << exit(FatalIOError);
    }
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

    velocity_(0) =
        (2*l + 1)*(in + out)*amplitude_(0) + both*amplitude_(1);
    velocity_(1) =
        both/s*amplitude_(0)
      + (
            in*(2*sqr(l) + l + 3)/l + out*(2*sqr(l) + 3*l + 4)/(l + 1)
        )*amplitude_(1);
    velocity_ *= radius_/det;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::analyticalSolution::polarFlow
Foam::capsule::analyticalSolutions::sphereMode::flow
(
    const scalar r,
    const scalar theta,
    const scalar,
    const bool in
) const
{
    if (l_ == 0)
    {
        return {0, 0, in ? -amplitude_(0) : 0};
    }

    const scalar l = l_;
    const scalar s = l*(l + 1);
    const scalar q = r/radius_;
    const scalar U = velocity_(0);
    const scalar V = velocity_(1);
    const vector2 Y = harmonic(theta);

    if (in)
    {
        const scalar A = (l + 1)*(l*V - U)/2;
        const scalar a = A*std::pow(q, l + 1);
        const scalar b = (U - A)*std::pow(q, l - 1);
        const scalar p = viscosity_.first()*(2*l + 3)*2*A/(l*radius_);
        return
        {
            (a + b)*Y(0),
            (a*(l + 3)/s + b/l)*Y(1),
            p*std::pow(q, l)*Y(0)
        };
    }
    const scalar C = l*((l + 1)*V + U)/2;
    const scalar c = C*std::pow(q, -l);
    const scalar d = (U - C)*std::pow(q, -l - 2);
    const scalar p = viscosity_.second()*(2*l - 1)*2*C/((l + 1)*radius_);
    return
    {
        (c + d)*Y(0),
        (c*(2 - l)/s - d/(l + 1))*Y(1),
        p*std::pow(q, -l - 1)*Y(0)
    };
}


Foam::capsule::vector2
Foam::capsule::analyticalSolutions::sphereMode::polarForce
(
    const scalar theta,
    const scalar
) const
{
    return amplitude_.cwiseProduct(harmonic(theta));
}
