/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceBending.H"

#include <Eigen/Geometry>
#include <Eigen/LU>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surfaceBending::forms::forms(const jet& x)
{
    const auto tangents = x.leftCols<2>();
    const Eigen::Matrix<scalar, 3, 1> across = x.col(0).cross(x.col(1));

    metric = tangents.transpose()*tangents;
    inverse = metric.inverse();
    area = across.norm();
    normal = across/area;
    dual = tangents*inverse;
    connection = dual.transpose()*x.rightCols<3>();

    const Eigen::Matrix<scalar, 1, 3> b = -normal.transpose()*x.rightCols<3>();
    curvature << b(0), b(1), b(1), b(2);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::surfaceBending::tensor2
Foam::capsule::surfaceBending::forms::symmetric(const tensor2& M) const
{
    return 0.5*(M + inverse*M.transpose()*metric);
}


Eigen::Matrix<Foam::scalar, 6, 15>
Foam::capsule::surfaceBending::forms::change(const jet& x) const
{
    // da_ab = x_a.dx_b + x_b.dx_a,
    // db_ab = -n.(dx_ab - (x^c.x_ab) dx_c), for dn = -x^c (n.dx_c)
    Eigen::Matrix<scalar, 6, 15> result = Eigen::Matrix<scalar, 6, 15>::Zero();

    result.block<1, 3>(0, 0) = 2*x.col(0).transpose();
    result.block<1, 3>(1, 0) = x.col(1).transpose();
    result.block<1, 3>(1, 3) = x.col(0).transpose();
    result.block<1, 3>(2, 3) = 2*x.col(1).transpose();
    for (label ab = 0; ab < 3; ++ab)
    {
        result.block<1, 3>(3 + ab, 6 + 3*ab) = -normal.transpose();
        for (label c = 0; c < 2; ++c)
        {
            result.block<1, 3>(3 + ab, 3*c) =
                connection(c, ab)*normal.transpose();
        }
    }
    return result;
}


Foam::capsule::surfaceBending::hessianMatrix
Foam::capsule::surfaceBending::forms::secondChange
(
    const Eigen::Matrix<scalar, 6, 1>& factors
) const
{
    // d2a_ab = 2 dx_a.dx_b, and for
    // d2n = 2 (x^c.dx_d) (n.dx_c) x^d - a^cd (n.dx_c) (n.dx_d) n:
    // d2b_ab = 2 (n.dx_c) x^c.(dx_ab - (x^d.x_ab) dx_d)
    //        - a^cd (n.dx_c) (n.dx_d) b_ab
    hessianMatrix half = hessianMatrix::Zero();

    half.block<3, 3>(0, 0).diagonal().setConstant(factors(0));
    half.block<3, 3>(0, 3).diagonal().setConstant(factors(1));
    half.block<3, 3>(3, 3).diagonal().setConstant(factors(2));

    const auto m = factors.tail<3>();
    const Eigen::Matrix<scalar, 2, 1> turning = connection*m;
    const scalar moment =
        m(0)*curvature(0, 0) + m(1)*curvature(0, 1) + m(2)*curvature(1, 1);

    for (label c = 0; c < 2; ++c)
    {
        const Eigen::Matrix<scalar, 3, 3> across =
            normal*dual.col(c).transpose();
        for (label ab = 0; ab < 3; ++ab)
        {
            half.block<3, 3>(3*c, 6 + 3*ab) += m(ab)*across;
        }
        for (label d = 0; d < 2; ++d)
        {
            half.block<3, 3>(3*c, 3*d) -=
                turning(d)*across
              + 0.5*moment*inverse(c, d)*normal*normal.transpose();
        }
    }
    return half + half.transpose();
}


// ************************************************************************* //
