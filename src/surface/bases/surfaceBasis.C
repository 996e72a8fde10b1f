/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceBasis.H"
#include "axisymmetricBasis.H"
#include "solvedDirections.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::twoPi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surfaceBasis::surfaceBasis(const label n)
:
    n_(n),
    analysis_(n, n),
    derivative_(n, n),
    weights_(nodalScalars::Constant(n, spacing()))
{
    nodalMatrix slopes(n, n);

    for (label j = 0; j < n; ++j)
    {
        // Orthogonality of the sampled functions: weight 2/N, but 1/N for the
        // constant and for the highest cosine of an even N
        nodalScalars column = functions(alpha(j))*(2.0/n);
        column(0) *= 0.5;
        if (n % 2 == 0)
        {
            column(n - 1) *= 0.5;
        }
        analysis_.col(j) = column;
        slopes.row(j) = functions(alpha(j), 1).transpose();
    }

    derivative_ = slopes*analysis_;
}


Foam::autoPtr<Foam::capsule::surfaceBasis> Foam::capsule::surfaceBasis::New
(
    const solvedDirections& directions,
    const label n
)
{
    return autoPtr<surfaceBasis>
    (
        directions.axisymmetric()
      ? new axisymmetricBasis(n, directions.axisAt())
      : new surfaceBasis(n)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::surfaceBasis::spacing() const
{
    return twoPi/n_;
}


Foam::capsule::nodalScalars Foam::capsule::surfaceBasis::functions
(
    const scalar alpha,
    const label order
) const
{
    // Order 1, cos, sin, cos 2, sin 2, ...; derivatives by a phase shift
    nodalScalars f(n_);
    f(0) = (order == 0 ? 1 : 0);

    const scalar c1 = std::cos(alpha);
    const scalar s1 = std::sin(alpha);
    scalar c = 1;
    scalar s = 0;

    for (label i = 1; i < n_; i += 2)
    {
        const scalar k = (i + 1)/2;
        const scalar next = c*c1 - s*s1;
        s = s*c1 + c*s1;
        c = next;

        f(i) = (order == 0 ? c : order == 1 ? -k*s : -k*k*c);
        if (i + 1 < n_)
        {
            f(i + 1) = (order == 0 ? s : order == 1 ? k*c : -k*k*s);
        }
    }

    return f;
}


Foam::capsule::nodalScalars Foam::capsule::surfaceBasis::integrated
(
    const nodalScalars& f
) const
{
    // A pair cos k, sin k of coefficients (a, b) becomes (-b, a)/k; the
    // highest cosine of an even N has no integral at the nodes
    const nodalScalars coeffs = analysis_*f;
    nodalScalars turned = nodalScalars::Zero(n_);
    for (label i = 1; i + 1 < n_; i += 2)
    {
        const scalar k = (i + 1)/2;
        turned(i) = -coeffs(i + 1)/k;
        turned(i + 1) = coeffs(i)/k;
    }

    nodalScalars result(n_);
    for (label j = 0; j < n_; ++j)
    {
        result(j) = functions(alpha(j)).dot(turned);
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::surfaceBasis::evaluation
(
    const nodalScalars& alphas
) const
{
    return functions(alphas)*analysis_;
}


Foam::capsule::nodalMatrix Foam::capsule::surfaceBasis::functions
(
    const nodalScalars& alphas
) const
{
    nodalMatrix f(alphas.size(), n_);
    for (Eigen::Index i = 0; i < alphas.size(); ++i)
    {
        f.row(i) = functions(alphas(i)).transpose();
    }
    return f;
}


Foam::capsule::nodalMatrix Foam::capsule::surfaceBasis::lowPass
(
    const scalar cutoff
) const
{
    nodalMatrix f(n_, n_);
    nodalScalars factors(n_);
    for (label j = 0; j < n_; ++j)
    {
        const label wave = (j + 1)/2;
        f.row(j) = functions(alpha(j)).transpose();
        factors(j) = std::exp(-sqr(pow4(wave/cutoff)));
    }
    return f*factors.asDiagonal()*analysis_;
}
