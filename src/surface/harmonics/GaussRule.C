/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "GaussRule.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- A Legendre polynomial and its derivative inside (-1, 1)
struct LegendreValue
{
    scalar value;
    scalar slope;
};

static LegendreValue Legendre(const label n, const scalar x)
{
    scalar before = 1;
    scalar value = x;
    for (label k = 2; k <= n; ++k)
    {
        const scalar next = ((2*k - 1)*x*value - (k - 1)*before)/k;
        before = value;
        value = next;
    }
    return {value, n*(before - x*value)/((1 - x)*(1 + x))};
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::GaussRule::GaussRule(const label n)
:
    nodes_(n),
    weights_(n)
{
    // The rule is even
    for (label i = 0; 2*i < n; ++i)
    {
        scalar x = std::cos(pi*(i + 0.75)/(n + 0.5));
        scalar step;
        do
        {
            const LegendreValue P = Legendre(n, x);
            step = P.value/P.slope;
            x -= step;
        } while (mag(step) > 1e-10);

        // Newton squares its error, so that x is exact to rounding
        nodes_(i) = -x;
        nodes_(n - 1 - i) = x;
        weights_(i) = 2/((1 - x)*(1 + x)*sqr(Legendre(n, x).slope));
        weights_(n - 1 - i) = weights_(i);
    }
}


// ************************************************************************* //
