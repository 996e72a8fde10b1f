/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceMechanics.H"
#include "mathematicalConstants.H"

#include <Eigen/Geometry>

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- What the derivative of the elastic force is made of at a node:
//  d(S^ab x_b) = S^ab dx_b + dS^ab x_b, where with X^a = A^ab x_b and the dual
//  tangents x^a = a^ab x_b
//      dI = 2 X^a.dx_a,        dJ = J x^a.dx_a,
//      d(a^ab) x_b = -x^b (x^a.dx_b) - a^ab (dx_b - n (n.dx_b)).
//  Per reference area, the membrane turns in its plane by
//      r = (n x y^a).dx_a,        y^a = (X^a + J x^a)/(l1 + l2),
//  at the energy (alpha + beta/J) r^2/4, and its normal at S^ab n_a n_b/2,
//  n_a = n.dx_a
struct elasticHessian
{
    typedef surfaceMetric::tensor2 tensor2;
    typedef surfaceMetric::vectorPair vectorPair;

    Eigen::Matrix<scalar, 3, 1> n;
    scalar alpha;
    scalar beta;
    tensor2 A;
    vectorPair xA;
    vectorPair xa;
    vectorPair dAlpha;
    vectorPair dBeta;
    tensor2 turning;
    vectorPair twist;

    //- At node k of a surface, sum the sum l1 + l2 of the stretches there
    elasticHessian
    (
        const surfaceMetric& surface,
        const secondPiolaStress& stress,
        const tensor2& inverseOfReference,
        const scalar J,
        const scalar sum,
        const label k,
        const bool fullTangent
    );

    //- Derivative of the force along tangent b by dx_c
    Eigen::Matrix<scalar, 3, 3> block(const label b, const label c) const;
};


elasticHessian::elasticHessian
(
    const surfaceMetric& surface,
    const secondPiolaStress& stress,
    const tensor2& inverseOfReference,
    const scalar J,
    const scalar sum,
    const label k,
    const bool fullTangent
)
:
    n(surface.normalAt(k)),
    alpha(stress.alpha(k)),
    beta(stress.beta(k)),
    A(inverseOfReference)
{
    const vectorPair x = surface.tangentsAt(k);
    const tensor2 a = surface.inverseAt(k);
    xA = x*A;
    xa = x*a;
    dAlpha = 2*stress.alphaI(k)*xA + J*stress.alphaJ(k)*xa;
    dBeta = 2*stress.betaI(k)*xA + J*stress.betaJ(k)*xa;

    const tensor2 S = alpha*A + beta*a;
    if (fullTangent)
    {
        turning = S;
        twist.setZero();
    }
    else
    {
        turning = surfaceMetric::tensilePart(S, x.transpose()*x, a);
        twist =
            std::sqrt(max(-0.5*(alpha + beta/J), 0.0))/sum
           *(xA + J*xa).colwise().cross(n);
    }
}


Eigen::Matrix<scalar, 3, 3> elasticHessian::block
(
    const label b,
    const label c
) const
{
    Eigen::Matrix<scalar, 3, 3> m =
        xA.col(b)*dAlpha.col(c).transpose()
      + xa.col(b)*dBeta.col(c).transpose()
      - beta*xa.col(c)*xa.col(b).transpose()
      + twist.col(b)*twist.col(c).transpose()
      + (turning(b, c) - alpha*A(b, c))*n*n.transpose();
    m.diagonal().array() += alpha*A(b, c);
    return m;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::surfaceMechanics::addElastic
(
    const nodalVectors& X,
    const bool fullTangent,
    List<nodalMatrix>& fields
) const
{
    const label nDerivatives = products_.nDerivatives();
    const surfaceMetric surface = metricOf(grid_, X);
    const secondPiolaStress stress = stressOf(surface);
    const nodalScalars J = reference_.areaRatio(surface);
    const nodalScalars sum =
        (reference_.firstInvariant(surface) + 2*J).cwiseSqrt();

    for (label k = 0; k < grid_.size(); ++k)
    {
        const elasticHessian hessian
        (
            surface, stress, reference_.inverseAt(k), J(k), sum(k), k, fullTangent
        );
        const scalar weight = grid_.weights()(k)*reference_.area()(k);

        for (label b = 0; b < 2; ++b)
        {
            for (label c = 0; c < 2; ++c)
            {
                const Eigen::Matrix<scalar, 3, 3> m = hessian.block(b, c);
                for (label ij = 0; ij < 9; ++ij)
                {
                    fields[ij](k, b*nDerivatives + c) +=
                        weight*m(ij/3, ij % 3);
                }
            }
        }
    }
}


void Foam::capsule::surfaceMechanics::addBending
(
    const nodalVectors& X,
    const bool fullTangent,
    List<nodalMatrix>& fields
) const
{
    const surfaceBending::nodalJets jets = jetsOf(X);

    for (label k = 0; k < grid_.size(); ++k)
    {
        const surfaceBending::hessianMatrix h =
            bending_->hessian(jets, k, fullTangent);

        for (label ab = 0; ab < 25; ++ab)
        {
            for (label ij = 0; ij < 9; ++ij)
            {
                fields[ij](k, ab) +=
                    grid_.weights()(k)
                   *h(3*(ab/5) + ij/3, 3*(ab % 5) + ij % 3);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::surfaceMechanics::jacobian
(
    const nodalVectors& X,
    const bool fullTangent
) const
{
    const label n = harmonics_.size();
    const label nFields =
        products_.nDerivatives()*products_.nDerivatives();
    List<nodalMatrix> fields
    (
        9,
        nodalMatrix::Zero(grid_.size(), nFields)
    );
    addElastic(X, fullTangent, fields);
    if (bending_.valid())
    {
        addBending(X, fullTangent, fields);
    }
    if (viscosity_.valid())
    {
        addViscous(X, fullTangent, fields);
    }
    const bool symmetric = law_->hasEnergy() && !viscosity_.valid();

    nodalMatrix result(3*n, 3*n);
    for (label i = 0; i < 3; ++i)
    {
        for (label j = 0; j < 3; ++j)
        {
            result.block(i*n, j*n, n, n) =
                symmetric && j < i
              ? nodalMatrix(result.block(j*n, i*n, n, n).transpose())
              : nodalMatrix(products_.product(fields[3*i + j])/(-4*pi));
        }
    }
    return result;
}


// ************************************************************************* //
