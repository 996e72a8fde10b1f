/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "jumpConditions.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Velocity at distances d, of [u_n] and [u_nn] beside each other
static nodalVectors extended(const nodalScalars& d, const nodalMatrix& u)
{
    const label n = u.cols()/2;
    return scaled(d, u.leftCols(n)) + scaled(d.cwiseAbs2()/2, u.rightCols(n));
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::jumpConditions::footPoints::footPoints
(
    const closedSurface& surface,
    const UList<surfaceParameter>& feet,
    const nodalScalars& d
)
:
    functions(surface.basis().functions(feet)),
    distance(d)
{}


Foam::capsule::jumpConditions::orientedFootPoints::orientedFootPoints
(
    const closedSurface& surface,
    const UList<surfaceParameter>& feet,
    const nodalScalars& d
)
:
    footPoints(surface, feet, d),
    normal(feet.size(), surface.nComponents())
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

    const label nValues = 2*d_ + 3;
    const label nTensor = d_*d_;
    nodalMatrix terms(surface.size(), nValues + 2*d_ + 2*nTensor);
    terms <<
        u1, u2, p0, p1, p2, slope0, slope1, surface.gradients(u1), K;
    const nodalMatrix coefficients = surface.basis().analysis()*terms;

    values_ = coefficients.leftCols(nValues);
    pressureGradient_.resize(coefficients.rows(), 2 + 2*d_ + nTensor);
    pressureGradient_ <<
        coefficients.middleCols(2*d_ + 1, 2 + 2*d_),
        coefficients.rightCols(nTensor);
    velocityCurvature_.resize(coefficients.rows(), 2*d_ + 2*nTensor);
    velocityCurvature_ <<
        coefficients.leftCols(2*d_),
        coefficients.rightCols(2*nTensor);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::jumpConditions::velocity
(
    const footPoints& at
) const
{
    const nodalMatrix u = at.functions*values_.leftCols(2*d_);
    return extended(at.distance, u);
}


void Foam::capsule::jumpConditions::values
(
    const footPoints& at,
    nodalVectors& velocity,
    nodalScalars& pressure
) const
{
    const nodalMatrix q = at.functions*values_;
    const nodalScalars& d = at.distance;

    velocity = extended(d, q.leftCols(2*d_));
    pressure =
        q.col(2*d_)
      + d.cwiseProduct
        (
            q.col(2*d_ + 1) + d.cwiseProduct(q.col(2*d_ + 2))/2
        );
}


Foam::capsule::nodalVectors Foam::capsule::jumpConditions::velocityCurvature
(
    const orientedFootPoints& at,
    const nodalMatrix& M
) const
{
    const nodalMatrix u = at.functions*velocityCurvature_;
    const label nTensor = d_*d_;

    // Along the normal, and by the curvature of the surface
    nodalVectors Mn(nodalVectors::Zero(M.rows(), d_));
    for (label ij = 0; ij < nTensor; ++ij)
    {
        Mn.col(ij/d_) += M.col(ij).cwiseProduct(at.normal.col(ij % d_));
    }
    const nodalScalars bend =
        M.cwiseProduct(u.rightCols(nTensor)).rowwise().sum();
    nodalVectors result =
        scaled(dot(Mn, at.normal), u.middleCols(d_, d_))
      + scaled(bend, u.leftCols(d_));

    // By the derivatives along the surface of [u_n]
    for (label i = 0; i < d_; ++i)
    {
        result += scaled(2*Mn.col(i), u.middleCols((2 + i)*d_, d_));
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::jumpConditions::pressureGradient
(
    const orientedFootPoints& at
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
