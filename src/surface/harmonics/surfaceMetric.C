/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceMetric.H"

#include <Eigen/Geometry>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surfaceMetric::surfaceMetric
(
    const nodalVectors& x0,
    const nodalVectors& x1
)
:
    tangents_{x0, x1}
{
    metric_[0] = dot(x0, x0);
    metric_[1] = dot(x0, x1);
    metric_[2] = dot(x1, x1);

    const nodalScalars determinant =
        metric_[0].cwiseProduct(metric_[2]) - metric_[1].cwiseAbs2();

    inverse_[0] = metric_[2].cwiseQuotient(determinant);
    inverse_[1] = -metric_[1].cwiseQuotient(determinant);
    inverse_[2] = metric_[0].cwiseQuotient(determinant);

    area_ = determinant.cwiseSqrt();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::surfaceMetric::firstInvariant
(
    const surfaceMetric& stretched
) const
{
    return
        inverse_[0].cwiseProduct(stretched.metric_[0])
      + 2*inverse_[1].cwiseProduct(stretched.metric_[1])
      + inverse_[2].cwiseProduct(stretched.metric_[2]);
}


Foam::capsule::surfaceMetric::tensor2
Foam::capsule::surfaceMetric::tensilePart
(
    const tensor2& S,
    const tensor2& metric,
    const tensor2& inverse
)
{
    // Principal values are those of S^ac a_cb
    const tensor2 mixed = S*metric;
    const scalar mean = 0.5*mixed.trace();
    const scalar root =
        std::sqrt(max(sqr(mean) - mixed.determinant(), scalar(0)));

    if (mean >= root)
    {
        return S;
    }
    if (mean <= -root)
    {
        return tensor2::Zero();
    }
    return (0.5*(mean + root)/root)*(S - (mean - root)*inverse);
}


Foam::capsule::surfaceMetric::vectorPair
Foam::capsule::surfaceMetric::tangentsAt(const label node) const
{
    vectorPair result;
    result << tangents_[0].row(node).transpose(),
        tangents_[1].row(node).transpose();
    return result;
}


Foam::capsule::surfaceMetric::tensor2
Foam::capsule::surfaceMetric::inverseAt(const label node) const
{
    tensor2 result;
    result <<
        inverse_[0](node), inverse_[1](node),
        inverse_[1](node), inverse_[2](node);
    return result;
}


Eigen::Matrix<Foam::scalar, 3, 1>
Foam::capsule::surfaceMetric::normalAt(const label node) const
{
    const vectorPair x = tangentsAt(node);

    return x.col(0).cross(x.col(1))/area_(node);
}


// ************************************************************************* //
