/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "closedCurve.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::closedCurve::closedCurve
(
    const periodicBasis& basis,
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
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::closedCurve::area() const
{
    return 0.5*integral(dot(x_.rowwise() - x_.colwise().mean(), n_));
}


Foam::capsule::vector2 Foam::capsule::closedCurve::centroid() const
{
    // Divergence theorem for x_i x/3, about the mean of the nodes so that a
    // curve far from the origin loses no digits; the same however it is turned
    const vector2 origin = x_.colwise().mean();
    const nodalVectors d = x_.rowwise() - origin;
    const nodalScalars dn = dot(d, n_);
    const scalar a = 0.5*integral(dn);
    return origin + vector2
    (
        integral(d.col(0).cwiseProduct(dn)),
        integral(d.col(1).cwiseProduct(dn))
    )/(3*a);
}


Eigen::Matrix<Foam::scalar, 3, 1>
Foam::capsule::closedCurve::secondMoments() const
{
    // Divergence theorem for x_i x_j x/4
    const nodalVectors d = x_.rowwise() - centroid();
    const nodalScalars dn = dot(d, n_)/4;
    const auto moment = [&](const label i, const label j)
    {
        return
            integral(d.col(i).cwiseProduct(d.col(j)).cwiseProduct(dn));
    };
    return Eigen::Matrix<scalar, 3, 1>(moment(0, 0), moment(0, 1), moment(1, 1));
}


Foam::scalar Foam::capsule::closedCurve::taylorDeformation() const
{
    // Principal moments are proportional to L^3 B and L B^3: their ratio is
    // (L/B)^2
    const Eigen::Matrix<scalar, 3, 1> m = secondMoments();
    const scalar mean = 0.5*(m(0) + m(2));
    const scalar spread = std::hypot(0.5*(m(0) - m(2)), m(1));
    if (mean <= spread)
    {
        // Crossed by itself, or a line
        return 1;
    }
    const scalar ratio = std::sqrt((mean + spread)/(mean - spread));
    return (ratio - 1)/(ratio + 1);
}


Foam::scalar Foam::capsule::closedCurve::inclination() const
{
    const Eigen::Matrix<scalar, 3, 1> m = secondMoments();
    const scalar size = mag(m(0)) + mag(m(2));
    const scalar spread = m(0) - m(2);
    if (std::hypot(spread, 2*m(1)) <= 1e-6*size)
    {
        return 0;
    }
    // What rounding leaves must not turn an axis along the second direction
    // from 90 to -90 degrees
    return 0.5*std::atan2(mag(m(1)) > 1e-10*size ? 2*m(1) : 0, spread);
}


Foam::capsule::vector2 Foam::capsule::closedCurve::extents() const
{
    vector2 result;
    for (label i = 0; i < 2; ++i)
    {
        // From the extreme sample to the extreme of the curve by Newton
        // iteration on the derivative
        const label m = 8*size();
        const nodalVectors x = sampled(m);
        scalar extreme[2];

        for (label side = 0; side < 2; ++side)
        {
            Eigen::Index k;
            side ? x.col(i).maxCoeff(&k) : x.col(i).minCoeff(&k);
            const scalar step = constant::mathematical::twoPi/m;
            scalar alpha = k*step;
            for (label iter = 0; iter < 4; ++iter)
            {
                const scalar slope = point(alpha, 1)(i);
                const scalar bend = point(alpha, 2)(i);
                if ((side ? -bend : bend) <= 0)
                {
                    break;
                }
                alpha -= std::max(-step, std::min(step, slope/bend));
            }
            extreme[side] = point(alpha)(i);
        }
        result(i) = extreme[1] - extreme[0];
    }
    return result;
}


void Foam::capsule::closedCurve::expand
(
    const scalar alpha,
    vector2& x,
    vector2& x1,
    vector2& x2
) const
{
    // As periodicBasis::functions, the three series in one
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


Foam::scalar Foam::capsule::closedCurve::nearest
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


Foam::capsule::nodalVectors Foam::capsule::closedCurve::sampled
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
