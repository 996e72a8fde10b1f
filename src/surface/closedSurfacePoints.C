/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "sphericalGrid.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::closedSurface::footStep
(
    const solvedVector& x,
    const surfacePoint& at,
    scalar (&step)[2]
) const
{
    // Newton on (x(a, b) - x).x_i = 0; where the distance is not convex, its
    // Gauss-Newton part alone
    const scalar maxStep = basis_->spacing();
    const solvedVector d = at.x - x;

    if (!spatial())
    {
        const scalar slope = d.dot(at.first[0]);
        const scalar gauss = at.first[0].squaredNorm();
        const scalar bend = gauss + d.dot(at.second[0]);
        const bool convex = (bend > 0.1*gauss);
        step[0] =
            std::max
            (
                -maxStep, std::min(maxStep, -slope/(convex ? bend : gauss))
            );
        step[1] = 0;
        return convex;
    }

    Eigen::Matrix<scalar, 2, 2> gauss, bend;
    Eigen::Matrix<scalar, 2, 1> slope;
    for (label i = 0; i < 2; ++i)
    {
        slope(i) = d.dot(at.first[i]);
        for (label j = 0; j < 2; ++j)
        {
            gauss(i, j) = at.first[i].dot(at.first[j]);
            bend(i, j) = gauss(i, j) + d.dot(at.second[i + j]);
        }
    }
    const Eigen::Matrix<scalar, 2, 2> excess = bend - 0.01*gauss;
    const bool convex = excess.trace() > 0 && excess.determinant() > 0;
    Eigen::Matrix<scalar, 2, 1> s =
        -((convex ? bend : gauss).inverse()*slope).eval();
    s *= std::min(scalar(1), maxStep/std::max(s.norm(), SMALL));
    step[0] = s(0);
    step[1] = s(1);
    return convex;
}


Foam::scalar Foam::capsule::closedSurface::longestTangent() const
{
    return std::sqrt
    (
        dot(dual_[0], dual_[0]).cwiseMax(dot(dual_[1], dual_[1]))
       .cwiseProduct(g_.cwiseAbs2()).maxCoeff()
    );
}


Foam::scalar Foam::capsule::closedSurface::extreme
(
    surfaceParameter at,
    const label i,
    const bool highest
) const
{
    // Newton on the derivatives of the coordinate
    const scalar sign = (highest ? -1 : 1);
    const scalar maxStep = 0.25*basis_->spacing();

    surfacePoint p = expand(at);
    for (label iter = 0; iter < 6; ++iter)
    {
        scalar step[2] = {0, 0};
        if (!spatial())
        {
            const scalar bend = p.second[0](i);
            if (sign*bend <= 0)
            {
                break;
            }
            step[0] = -p.first[0](i)/bend;
        }
        else
        {
            Eigen::Matrix<scalar, 2, 2> bend;
            bend << p.second[0](i), p.second[1](i),
                p.second[1](i), p.second[2](i);
            if (sign*bend.trace() <= 0 || bend.determinant() <= 0)
            {
                break;
            }
            const Eigen::Matrix<scalar, 2, 1> slope
            (
                p.first[0](i), p.first[1](i)
            );
            const Eigen::Matrix<scalar, 2, 1> s = -bend.inverse()*slope;
            step[0] = s(0);
            step[1] = s(1);
        }
        const scalar length = std::hypot(step[0], step[1]);
        for (scalar& s : step)
        {
            s *= std::min(scalar(1), maxStep/std::max(length, SMALL));
        }
        at = basis_->moved(at, step);
        p = expand(at);
    }
    return p.x(i);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::solvedVector Foam::capsule::closedSurface::normal
(
    const surfacePoint& at
)
{
    const solvedVector& a = at.first[0];
    if (a.size() == 2)
    {
        return vector2(a(1), -a(0));
    }
    const solvedVector& b = at.first[1];
    solvedVector n(3);
    n << a(1)*b(2) - a(2)*b(1), a(2)*b(0) - a(0)*b(2), a(0)*b(1) - a(1)*b(0);
    return n;
}


Foam::capsule::surfacePoint Foam::capsule::closedSurface::foot
(
    const solvedVector& x,
    surfaceParameter& at
) const
{
    // Until the step is round-off; where Newton's steps go on as the last two,
    // quadratically, until the next one would be
    surfacePoint p;
    scalar step[2] = {0, 0};
    scalar last = 0;
    scalar length = 0;
    for (label iter = 0; iter < 20; ++iter)
    {
        p = expand(at);
        const bool convex = footStep(x, p, step);
        at = basis_->moved(at, step);

        length = std::hypot(step[0], step[1]);
        if
        (
            length < 1e-12
         || (convex && length < 1e-6 && pow3(length) < 1e-13*sqr(last))
        )
        {
            break;
        }
        last = length;
    }

    // What the last step changes: without another expansion, if it is small
    if (length >= 1e-6)
    {
        return expand(at);
    }
    if (spatial())
    {
        p.x +=
            step[0]*p.first[0] + step[1]*p.first[1]
          + 0.5*sqr(step[0])*p.second[0] + step[0]*step[1]*p.second[1]
          + 0.5*sqr(step[1])*p.second[2];
        p.first[0] += step[0]*p.second[0] + step[1]*p.second[1];
        p.first[1] += step[0]*p.second[1] + step[1]*p.second[2];
    }
    else
    {
        p.x += step[0]*p.first[0] + 0.5*sqr(step[0])*p.second[0];
        p.first[0] += step[0]*p.second[0];
    }
    return p;
}


Foam::scalar Foam::capsule::closedSurface::signedDistance
(
    const solvedVector& x,
    surfaceParameter& at
) const
{
    const surfacePoint p = foot(x, at);
    const solvedVector d = x - p.x;

    return d.dot(normal(p)) < 0 ? -d.norm() : d.norm();
}


Foam::capsule::nodalVectors Foam::capsule::closedSurface::sampled() const
{
    const List<surfaceParameter>& samples = basis_->samples();
    nodalVectors x(samples.size(), nComponents());
    forAll(samples, i)
    {
        x.row(i) = expand(samples[i]).x;
    }
    return x;
}


Foam::capsule::surfaceSamples Foam::capsule::closedSurface::samples
(
    const scalar spacing
) const
{
    if (!spatial())
    {
        return surfaceSamples(x_);
    }
    const sphericalGrid grid
    (
        sphericalHarmonics(0),
        label(constant::mathematical::pi*longestTangent()/spacing),
        0
    );
    nodalVectors points(grid.size(), 3);
    nodalVectors normals(grid.size(), 3);
    forAll(grid.nodes(), i)
    {
        const surfacePoint p = expand(grid.nodes()[i]);
        points.row(i) = p.x;
        normals.row(i) = normal(p).normalized();
    }
    return surfaceSamples(points, normals);
}


Foam::scalar Foam::capsule::closedSurface::sampleSpacing() const
{
    const label n = basis_->samples().size();
    if (!spatial())
    {
        return 2*perimeter()/n;
    }
    // Half the diagonal of a cell of samples, which are sqrt(2 pi^2/n) apart
    return longestTangent()*constant::mathematical::pi/std::sqrt(scalar(n));
}


Foam::capsule::solvedVector Foam::capsule::closedSurface::extents() const
{
    const List<surfaceParameter>& samples = basis_->samples();
    const nodalVectors x = sampled();

    solvedVector result(nComponents());
    for (label i = 0; i < nComponents(); ++i)
    {
        Eigen::Index lowest, highest;
        x.col(i).minCoeff(&lowest);
        x.col(i).maxCoeff(&highest);
        result(i) =
            extreme(samples[highest], i, true)
          - extreme(samples[lowest], i, false);
    }
    return result;
}


// ************************************************************************* //
