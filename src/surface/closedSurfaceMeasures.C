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

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::closedSurface::volume() const
{
    const nodalVectors d = x_.rowwise() - x_.colwise().mean();

    return
        axisymmetric()
      ? integral(nodalScalars(d.col(0).cwiseProduct(n_.col(0))))
      : 0.5*integral(dot(d, n_));
}


Foam::capsule::nodalVectors Foam::capsule::closedSurface::volumeDerivative()
const
{
    return scaled(basis_->weights().cwiseProduct(areaElement()), n_);
}


Foam::capsule::vector2 Foam::capsule::closedSurface::flow
(
    const nodalVectors& U
) const
{
    // Divergence theorem for x (U.n), about the centroid so that it is the same
    // wherever the surface is
    const nodalVectors d = x_.rowwise() - centroid();

    return resultant(scaled(dot(U, n_), d));
}


Foam::capsule::vector2 Foam::capsule::closedSurface::centroid() const
{
    // Divergence theorem, about the mean of the nodes so that a curve far from
    // the origin loses no digits: in the plane for x_i x/3, the same however it
    // is turned; along an axis for x^2/2
    const vector2 origin = x_.colwise().mean();
    const nodalVectors d = x_.rowwise() - origin;

    if (axisymmetric())
    {
        const scalar along = integral
        (
            nodalScalars(d.col(0).cwiseAbs2().cwiseProduct(n_.col(0)))
        );
        return origin + vector2(along/(2*volume()), 0);
    }

    const nodalScalars dn = dot(d, n_);
    return origin + integrals(scaled(dn, d))/(3*0.5*integral(dn));
}


Eigen::Matrix<Foam::scalar, 3, 1>
Foam::capsule::closedSurface::secondMoments() const
{
    const nodalVectors d = x_.rowwise() - centroid();

    if (axisymmetric())
    {
        // Divergence theorem for x^3/3 and, with y^2 = r^2/2 on average around
        // the axis, for x r^2/2
        const nodalScalars x = d.col(0);
        const nodalScalars xn = x.cwiseProduct(n_.col(0));
        return Eigen::Matrix<scalar, 3, 1>
        (
            integral(nodalScalars(x.cwiseAbs2().cwiseProduct(xn)))/3,
            0,
            integral(nodalScalars(c_.cwiseAbs2().cwiseProduct(xn)))/2
        );
    }

    // Divergence theorem for x_i x_j x/4
    const nodalScalars dn = dot(d, n_)/4;
    const auto moment = [&](const label i, const label j)
    {
        return integral
        (
            nodalScalars(d.col(i).cwiseProduct(d.col(j)).cwiseProduct(dn))
        );
    };
    return Eigen::Matrix<scalar, 3, 1>(moment(0, 0), moment(0, 1), moment(1, 1));
}


Foam::scalar Foam::capsule::closedSurface::taylorDeformation() const
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


Foam::scalar Foam::capsule::closedSurface::inclination() const
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


Foam::capsule::vector2 Foam::capsule::closedSurface::extents() const
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


// ************************************************************************* //
