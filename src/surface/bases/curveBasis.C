/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "curveBasis.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::twoPi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::curveBasis::curveBasis(const label n)
:
    n_(n)
{
    weights_ = nodalScalars::Constant(n, spacing());
    analysis_.resize(n, n);
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

    derivative_[0] = slopes*analysis_;

    samples_.setSize(4*n);
    forAll(samples_, i)
    {
        samples_[i] = surfaceParameter(i*twoPi/samples_.size(), 0, 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::curveBasis::spacing() const
{
    return twoPi/n_;
}


Foam::capsule::nodalScalars Foam::capsule::curveBasis::functions
(
    const scalar alpha,
    const label order
) const
{
    nodalScalars f(n_);
    setFunctions(alpha, order, f);
    return f;
}


void Foam::capsule::curveBasis::setFunctions
(
    const scalar alpha,
    const label order,
    Eigen::Ref<nodalScalars> f
) const
{
    // Order 1, cos, sin, cos 2, sin 2, ...; derivatives by a phase shift
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
}


Foam::capsule::nodalScalars Foam::capsule::curveBasis::integrated
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


Foam::capsule::nodalMatrix Foam::capsule::curveBasis::functions
(
    const UList<surfaceParameter>& at
) const
{
    // Those of a point beside each other
    nodalMatrix f(n_, at.size());
    forAll(at, i)
    {
        setFunctions(at[i][0], 0, f.col(i));
    }
    return f.transpose();
}


Foam::capsule::nodalFilter Foam::capsule::curveBasis::lowPass
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
    return nodalFilter(f, factors, analysis_);
}


Foam::capsule::nodalScalars Foam::capsule::curveBasis::shortestWave() const
{
    nodalScalars wave(n_);
    for (label i = 0; i < n_; ++i)
    {
        wave(i) = (i % 2 ? -1 : 1);
    }
    return wave;
}


Foam::capsule::surfacePoint Foam::capsule::curveBasis::expand
(
    const surfaceParameter& at,
    const nodalVectors& coefficients
) const
{
    // As functions, the three series in one
    const scalar c1 = std::cos(at[0]);
    const scalar s1 = std::sin(at[0]);
    scalar c = 1;
    scalar s = 0;

    vector2 x = coefficients.row(0);
    vector2 x1 = vector2::Zero();
    vector2 x2 = vector2::Zero();
    const label n = coefficients.rows();
    for (label i = 1; i < n; i += 2)
    {
        const scalar k = (i + 1)/2;
        const scalar next = c*c1 - s*s1;
        s = s*c1 + c*s1;
        c = next;

        const vector2 a(coefficients(i, 0), coefficients(i, 1));
        vector2 wave = c*a;
        vector2 slope = -s*a;
        if (i + 1 < n)
        {
            const vector2 b(coefficients(i + 1, 0), coefficients(i + 1, 1));
            wave += s*b;
            slope += c*b;
        }
        x += wave;
        x1 += k*slope;
        x2 -= k*k*wave;
    }

    surfacePoint result;
    result.x = x;
    result.first[0] = x1;
    result.second[0] = x2;
    return result;
}


// ************************************************************************* //
