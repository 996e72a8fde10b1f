/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "lineResponse.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;
using Foam::constant::mathematical::twoPi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Weights of Int ln(4 sin^2((a - b)/2)) g(b) db, by distance of the nodes
static nodalScalars logarithmWeights(const label n)
{
    nodalScalars cosines(n);
    for (label j = 0; j < n; ++j)
    {
        cosines(j) = std::cos(j*twoPi/n);
    }
    nodalScalars weights(n);
    for (label j = 0; j < n; ++j)
    {
        scalar sum = 0;
        for (label m = 1; 2*m < n; ++m)
        {
            sum += cosines(m*j % n)/m;
        }
        weights(j) = -2*twoPi/n*sum;
        if (n % 2 == 0)
        {
            weights(j) -= 2*twoPi/sqr(scalar(n))*(j % 2 ? -1 : 1);
        }
    }
    return weights;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::lineResponse::singleLayer
(
    const closedSurface& curve,
    const scalar mu
)
{
    const label n = curve.size();
    const scalar h = curve.basis().spacing();
    const nodalScalars weights = logarithmWeights(n);
    nodalMatrix result(2*n, 2*n);

    // A net force would drag an unbounded plane fluid without limit: the
    // logarithm is that of distance over the size of the curve
    const scalar size = curve.perimeter()/twoPi;

    // Squares of the nodes' distances on a circle of that size
    nodalScalars chords(n);
    for (label j = 0; j < n; ++j)
    {
        chords(j) = 4*sqr(size*std::sin(0.5*h*j));
    }

    // Symmetric but for the length that a node stands for
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            const vector2 r = curve.nodes().row(i) - curve.nodes().row(j);
            const scalar r2 = r.squaredNorm();
            const scalar smooth =
                i == j
              ? std::log(curve.metric()(i)/size)
              : 0.5*std::log(r2/chords(i - j));
            const scalar logarithm = h*smooth + 0.5*weights(i - j);

            const vector2 e =
                i == j
              ? vector2(curve.tangent().row(i))
              : vector2(r/std::sqrt(r2));
            for (label a = 0; a < 2; ++a)
            {
                for (label b = 0; b < 2; ++b)
                {
                    const scalar kernel =
                        (h*e(a)*e(b) - (a == b ? logarithm : 0))/(4*pi*mu);
                    result(a*n + i, b*n + j) = curve.metric()(j)*kernel;
                    result(a*n + j, b*n + i) = curve.metric()(i)*kernel;
                }
            }
        }
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::lineResponse::adjointDoubleLayer
(
    const closedSurface& curve
)
{
    const label n = curve.size();
    const scalar h = curve.basis().spacing();
    nodalMatrix result(2*n, 2*n);

    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const vector2 r = curve.nodes().row(i) - curve.nodes().row(j);
            const vector2 e =
                i == j
              ? vector2(curve.tangent().row(i))
              : vector2(r.normalized());

            // (r.n)/r^2 tends to half the curvature
            const scalar kernel =
                i == j
              ? 0.5*curve.curvature()(i)
              : r.dot(curve.normal().row(i))/r.squaredNorm();

            const scalar scale = -h*curve.metric()(j)*kernel/pi;
            for (label a = 0; a < 2; ++a)
            {
                for (label b = 0; b < 2; ++b)
                {
                    result(a*n + i, b*n + j) = scale*e(a)*e(b);
                }
            }
        }
    }
    return result;
}
