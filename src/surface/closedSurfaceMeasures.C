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

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::closedSurface::meanRadius() const
{
    return spatial() ? std::sqrt(area()/(4*pi)) : perimeter()/(2*pi);
}


Foam::scalar Foam::capsule::closedSurface::volume() const
{
    const nodalVectors d = x_.rowwise() - x_.colwise().mean();

    return
        axisymmetric()
      ? integral(nodalScalars(d.col(0).cwiseProduct(n_.col(0))))
      : integral(dot(d, n_))/nComponents();
}


Foam::capsule::nodalVectors Foam::capsule::closedSurface::volumeDerivative()
const
{
    return scaled(basis_->weights().cwiseProduct(areaElement()), n_);
}


Foam::capsule::solvedVector Foam::capsule::closedSurface::flow
(
    const nodalVectors& U
) const
{
    // Divergence theorem for x (U.n), about the centroid so that it is the same
    // wherever the surface is
    const nodalVectors d = x_.rowwise() - centroid();

    return resultant(scaled(dot(U, n_), d));
}


Foam::capsule::solvedVector Foam::capsule::closedSurface::centroid() const
{
    // Divergence theorem, about the mean of the nodes so that a curve far from
    // the origin loses no digits: for x_i x/(d + 1), the same however it is
    // turned; along an axis for x^2/2
    const solvedVector origin = x_.colwise().mean();
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
    return
        origin
      + integrals(scaled(dn, d))
       /((nComponents() + 1)*(integral(dn)/nComponents()));
}


Foam::capsule::solvedTensor
Foam::capsule::closedSurface::secondMoments() const
{
    const nodalVectors d = x_.rowwise() - centroid();
    solvedTensor result(nComponents(), nComponents());

    if (axisymmetric())
    {
        // Divergence theorem for x^3/3 and, with y^2 = r^2/2 on average around
        // the axis, for x r^2/2
        const nodalScalars x = d.col(0);
        const nodalScalars xn = x.cwiseProduct(n_.col(0));
        result.setZero();
        result(0, 0) = integral(nodalScalars(x.cwiseAbs2().cwiseProduct(xn)))/3;
        result(1, 1) =
            integral(nodalScalars(c_.cwiseAbs2().cwiseProduct(xn)))/2;
        return result;
    }

    // Divergence theorem for x_i x_j x/(d + 2)
    const nodalScalars dn = dot(d, n_)/(nComponents() + 2);
    for (label i = 0; i < nComponents(); ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            result(i, j) = result(j, i) = integral
            (
                nodalScalars(d.col(i).cwiseProduct(d.col(j)).cwiseProduct(dn))
            );
        }
    }
    return result;
}


Foam::capsule::solvedVector Foam::capsule::closedSurface::semiAxes() const
{
    // Second moments are proportional to the squares of the axes
    const solvedTensor m = secondMoments();
    solvedVector squares;
    if (spatial())
    {
        squares =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix<scalar, 3, 3>>(m)
           .eigenvalues().reverse().transpose();
    }
    else
    {
        const scalar mean = 0.5*(m(0, 0) + m(1, 1));
        const scalar spread = std::hypot(0.5*(m(0, 0) - m(1, 1)), m(0, 1));
        squares = vector2(mean + spread, mean - spread);
    }

    if (!(squares.minCoeff() > 0))
    {
        return solvedVector();
    }
    const solvedVector axes = squares.cwiseSqrt();
    scalar unit = pi*axes.prod();
    if (spatial())
    {
        unit *= 4.0/3;
        return axes*std::cbrt(volume()/unit);
    }
    if (axisymmetric())
    {
        const bool prolate = (m(0, 0) > m(1, 1));
        unit *= 4.0/3*axes(prolate ? 1 : 0);
        return axes*std::cbrt(volume()/unit);
    }
    return axes*std::sqrt(volume()/unit);
}


Foam::scalar Foam::capsule::closedSurface::taylorDeformation() const
{
    const solvedVector axes = semiAxes();
    if (axes.size() == 0)
    {
        // Crossed by itself, or a line
        return 1;
    }
    const scalar ratio = axes(0)/axes(axes.size() - 1);
    return (ratio - 1)/(ratio + 1);
}


Foam::scalar Foam::capsule::closedSurface::inclination() const
{
    const solvedTensor m = secondMoments();
    const scalar size = m.diagonal().cwiseAbs().sum();
    const scalar along = m(0, 0) - m(1, 1);
    const scalar across = 2*m(0, 1);
    if (std::hypot(along, across) <= 1e-6*size)
    {
        return 0;
    }

    // What rounding leaves must not turn an axis along the second direction
    // from 90 to -90 degrees
    return 0.5*std::atan2(mag(across) > 2e-10*size ? across : 0, along);
}


// ************************************************************************* //
