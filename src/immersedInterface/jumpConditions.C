/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "jumpConditions.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::jumpConditions::footPoints::footPoints
(
    const closedSurface& surface,
    const UList<surfaceParameter>& feet,
    const nodalScalars& d
)
:
    functions(surface.basis().functions(feet)),
    normal(feet.size(), surface.nComponents()),
    distance(d)
{
    forAll(feet, i)
    {
        normal.row(i) =
            closedSurface::normal(surface.expand(feet[i])).normalized();
    }
}


Foam::capsule::jumpConditions::jumpConditions
(
    const closedSurface& surface,
    const nodalVectors& f,
    const nodalVectors& m,
    const nodalScalars& c,
    const scalar mu
)
:
    d_(surface.nComponents())
{
    const nodalVectors& n = surface.normal();
    const nodalScalars H = surface.totalCurvature();
    const nodalMatrix K = surface.curvatureTensor();

    const nodalVectors u1 = -surface.tangential(f)/mu;
    const nodalScalars p0 = dot(f, n);
    const nodalVectors slope0 = surface.gradient(p0);
    const nodalScalars p1 = -mu*surface.divergence(u1) - dot(m, n);
    const nodalVectors slope1 = surface.gradient(p1);
    const nodalVectors u2 =
        (scaled(p1, n) + slope0 + m)/mu - scaled(H, u1);
    const nodalScalars p2 =
        c - surface.divergence(slope0) - H.cwiseProduct(p1);

    const label N = surface.size();
    const auto coefficients = [&](const nodalMatrix& terms)
    {
        return nodalMatrix(surface.basis().analysis()*terms);
    };

    nodalMatrix terms(N, 2*d_);
    terms << u1, u2;
    velocity_ = coefficients(terms);

    terms.resize(N, 3);
    terms << p0, p1, p2;
    pressure_ = coefficients(terms);

    terms.resize(N, 2 + 2*d_ + d_*d_);
    terms << p1, p2, slope0, slope1, K;
    pressureGradient_ = coefficients(terms);

    terms.resize(N, 2*d_ + 2*d_*d_);
    terms << u1, u2, surface.gradients(u1), K;
    velocityCurvature_ = coefficients(terms);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::jumpConditions::velocity
(
    const footPoints& at
) const
{
    const nodalMatrix u = at.functions*velocity_;
    const nodalScalars& d = at.distance;

    return scaled(d, u.leftCols(d_)) + scaled(d.cwiseAbs2()/2, u.rightCols(d_));
}


Foam::capsule::nodalVectors Foam::capsule::jumpConditions::velocityCurvature
(
    const footPoints& at,
    const nodalVectors& d
) const
{
    const nodalMatrix u = at.functions*velocityCurvature_;
    const nodalScalars n = dot(d, at.normal);

    nodalVectors result = scaled(n.cwiseAbs2(), u.middleCols(d_, d_));
    for (label i = 0; i < d_; ++i)
    {
        // The derivatives along the surface of [u_n], and its curvature
        result += scaled
        (
            2*n.cwiseProduct(d.col(i)), u.middleCols((2 + i)*d_, d_)
        );
        for (label j = 0; j < d_; ++j)
        {
            const nodalScalars bend =
                u.col(2*d_ + d_*d_ + i*d_ + j)
               .cwiseProduct(d.col(i)).cwiseProduct(d.col(j));
            result += scaled(bend, u.leftCols(d_));
        }
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::jumpConditions::pressure
(
    const footPoints& at
) const
{
    const nodalMatrix p = at.functions*pressure_;
    const nodalScalars& d = at.distance;

    return p.col(0) + d.cwiseProduct(p.col(1) + d.cwiseProduct(p.col(2))/2);
}


Foam::capsule::nodalVectors Foam::capsule::jumpConditions::pressureGradient
(
    const footPoints& at
) const
{
    const nodalMatrix p = at.functions*pressureGradient_;
    const nodalScalars& d = at.distance;
    const nodalScalars normal = p.col(0) + d.cwiseProduct(p.col(1));
    const nodalVectors along =
        p.middleCols(2, d_) + scaled(d, p.middleCols(2 + d_, d_));

    nodalVectors result = scaled(normal, at.normal);
    solvedTensor parallel(d_, d_);
    for (label k = 0; k < result.rows(); ++k)
    {
        // From the foot to the parallel surface
        for (label i = 0; i < d_; ++i)
        {
            for (label j = 0; j < d_; ++j)
            {
                parallel(i, j) =
                    (i == j) + d(k)*p(k, 2 + 2*d_ + i*d_ + j);
            }
        }
        if (d_ == 2)
        {
            const Eigen::Matrix<scalar, 2, 2> plane = parallel;
            result.row(k) += along.row(k)*plane.inverse();
        }
        else
        {
            const Eigen::Matrix<scalar, 3, 3> space = parallel;
            result.row(k) += along.row(k)*space.inverse();
        }
    }
    return result;
}


// ************************************************************************* //
