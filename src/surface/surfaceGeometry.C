/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceGeometry.H"
#include "byColumns.H"
#include "sphericalBasis.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::surfaceGeometry::setCurve()
{
    // About the mean: nothing is lost far from the origin
    const solvedVector mean = x_.colwise().mean();
    const nodalVectors d = x_.rowwise() - mean;
    const nodalVectors x1 = byColumns(basis_->derivative(), d);
    const nodalVectors x2 = byColumns(basis_->derivative(), x1);

    // Short waves that are round-off are none
    coeffs_ = byColumns(basis_->analysis(), d);
    const scalar roundOff = SMALL*d.cwiseAbs().maxCoeff();
    label n = coeffs_.rows();
    while (n > 1 && coeffs_.row(n - 1).cwiseAbs().maxCoeff() < roundOff)
    {
        --n;
    }
    coeffs_.conservativeResize(n, 2);
    coeffs_.row(0) += mean;

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

    c_ = basis_->curve().around(x_);
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


void Foam::capsule::surfaceGeometry::setSpatial()
{
    coeffs_ = byColumns(basis_->analysis().topRows(basis_->nPacked()), x_);

    const sphericalGrid& grid = basis_->spherical().grid();
    const label n = coeffs_.rows();
    const nodalVectors a =
        byColumns(grid.derivative(0).leftCols(n), coeffs_);
    const nodalVectors b =
        byColumns(grid.derivative(1).leftCols(n), coeffs_);

    n_.resize(size(), 3);
    for (label i = 0; i < 3; ++i)
    {
        const label j = (i + 1) % 3;
        const label k = (i + 2) % 3;
        n_.col(i) =
            a.col(j).cwiseProduct(b.col(k)) - a.col(k).cwiseProduct(b.col(j));
    }
    g_ = n_.rowwise().norm();
    const nodalScalars inverse = g_.cwiseInverse();
    n_ = scaled(inverse, n_);

    const nodalScalars square = inverse.cwiseAbs2();
    const nodalScalars aa = square.cwiseProduct(dot(a, a));
    const nodalScalars ab = square.cwiseProduct(dot(a, b));
    const nodalScalars bb = square.cwiseProduct(dot(b, b));
    dual_[0] = scaled(bb, a) - scaled(ab, b);
    dual_[1] = scaled(aa, b) - scaled(ab, a);
}


Foam::capsule::nodalVectors Foam::capsule::surfaceGeometry::secondForm() const
{
    const sphericalGrid& grid = basis_->spherical().grid();

    nodalVectors result(size(), 3);
    for (label i = 0; i < 3; ++i)
    {
        result.col(i) = dot
        (
            grid.secondDerivative(i/2, (i + 1)/2).leftCols(coeffs_.rows())
           *coeffs_,
            n_
        );
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surfaceGeometry::surfaceGeometry
(
    const surfaceBasis& basis,
    const nodalVectors& x
)
:
    basis_(&basis),
    x_(x)
{
    if (spatial())
    {
        setSpatial();
    }
    else
    {
        setCurve();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars
Foam::capsule::surfaceGeometry::totalCurvature() const
{
    if (!spatial())
    {
        return
            axisymmetric() ? nodalScalars(kappa_ + secondCurvature_) : kappa_;
    }
    const nodalVectors b = secondForm();
    return
       -b.col(0).cwiseProduct(dot(dual_[0], dual_[0]))
      - 2*b.col(1).cwiseProduct(dot(dual_[0], dual_[1]))
      - b.col(2).cwiseProduct(dot(dual_[1], dual_[1]));
}


Foam::capsule::nodalMatrix
Foam::capsule::surfaceGeometry::curvatureTensor() const
{
    const label d = nComponents();
    nodalVectors b;
    if (spatial())
    {
        b = secondForm();
    }

    nodalMatrix result(size(), d*d);
    for (label i = 0; i < d; ++i)
    {
        for (label j = 0; j < d; ++j)
        {
            const auto product =
                [&](const nodalVectors& u, const nodalVectors& v)
                {
                    return nodalScalars(u.col(i).cwiseProduct(v.col(j)));
                };
            if (spatial())
            {
                result.col(i*d + j) =
                   -b.col(0).cwiseProduct(product(dual_[0], dual_[0]))
                  - b.col(1).cwiseProduct
                    (
                        product(dual_[0], dual_[1])
                      + product(dual_[1], dual_[0])
                    )
                  - b.col(2).cwiseProduct(product(dual_[1], dual_[1]));
            }
            else
            {
                result.col(i*d + j) = kappa_.cwiseProduct(product(t_, t_));
            }
        }
    }
    return result;
}


// ************************************************************************* //
