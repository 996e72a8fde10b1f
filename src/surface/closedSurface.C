/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::closedSurface::closedSurface
(
    const surfaceBasis& basis,
    const nodalVectors& x
)
:
    basis_(&basis),
    x_(x),
    coeffs_(basis.analysis()*x)
{
    // About the mean: nothing is lost far from the origin
    const nodalVectors x1 =
        basis.derivative()*(x.rowwise() - x.colwise().mean());
    const nodalVectors x2 = basis.derivative()*x1;

    g_ = x1.rowwise().norm();
    t_ = g_.cwiseInverse().asDiagonal()*x1;
    n_.resize(size(), 2);
    n_.col(0) = t_.col(1);
    n_.col(1) = -t_.col(0);
    kappa_ =
    (
        (
            x1.col(0).array()*x2.col(1).array()
          - x1.col(1).array()*x2.col(0).array()
        )/g_.array().cube()
    ).matrix();

    c_ = basis.around(x);
    if (axisymmetric())
    {
        convergence_ = t_.col(1).cwiseQuotient(c_);
        secondCurvature_ = n_.col(1).cwiseQuotient(c_);
    }
    else
    {
        convergence_ = secondCurvature_ = nodalScalars::Zero(size());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::vector2 Foam::capsule::closedSurface::integrals
(
    const nodalVectors& f
) const
{
    return vector2
    (
        integral(nodalScalars(f.col(0))), integral(nodalScalars(f.col(1)))
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::closedSurface::divergence
(
    const nodalScalars& v
) const
{
    nodalScalars result = ds(v);
    if (axisymmetric())
    {
        result += convergence_.cwiseProduct(v);
    }
    return result;
}


Foam::scalar Foam::capsule::closedSurface::integral(const nodalScalars& f) const
{
    return
        axisymmetric()
      ? basis_->weights().dot(areaElement().cwiseProduct(f))
      : basis_->spacing()*g_.dot(f);
}


Foam::capsule::vector2 Foam::capsule::closedSurface::resultant
(
    const nodalVectors& f
) const
{
    return
        axisymmetric()
      ? vector2(integral(nodalScalars(f.col(0))), 0)
      : integrals(f);
}


void Foam::capsule::closedSurface::expand
(
    const scalar alpha,
    vector2& x,
    vector2& x1,
    vector2& x2
) const
{
    // As surfaceBasis::functions, the three series in one
    const scalar c1 = std::cos(alpha);
    const scalar s1 = std::sin(alpha);
    scalar c = 1;
    scalar s = 0;
    x = coeffs_.row(0);
    x1.setZero();
    x2.setZero();
    for (label i = 1; i < size(); i += 2)
    {
        const scalar k = (i + 1)/2;
        const scalar next = c*c1 - s*s1;
        s = s*c1 + c*s1;
        c = next;

        vector2 wave = c*coeffs_.row(i);
        vector2 slope = -s*coeffs_.row(i);
        if (i + 1 < size())
        {
            wave += s*coeffs_.row(i + 1);
            slope += c*coeffs_.row(i + 1);
        }
        x += wave;
        x1 += k*slope;
        x2 -= k*k*wave;
    }
}


Foam::scalar Foam::capsule::closedSurface::nearest
(
    const vector2& x,
    scalar alpha
) const
{
    const scalar maxStep = basis_->spacing();

    for (label iter = 0; iter < 20; ++iter)
    {
        vector2 x0, x1, x2;
        expand(alpha, x0, x1, x2);
        const vector2 d = x0 - x;

        // Newton on (x(alpha) - x).x' = 0; where the distance is not convex,
        // its Gauss-Newton part alone
        const scalar slope = d.dot(x1);
        const scalar gauss = x1.squaredNorm();
        const scalar bend = gauss + d.dot(x2);
        scalar step = slope/(bend > 0.1*gauss ? bend : gauss);
        step = std::max(-maxStep, std::min(maxStep, step));
        alpha -= step;

        if (std::abs(step) < 1e-12)
        {
            break;
        }
    }
    return alpha;
}


Foam::capsule::nodalVectors Foam::capsule::closedSurface::sampled
(
    const label m
) const
{
    nodalVectors x(m, 2);
    for (label i = 0; i < m; ++i)
    {
        x.row(i) = point(constant::mathematical::twoPi*i/m);
    }
    return x;
}
