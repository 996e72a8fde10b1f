/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "sphericalBasis.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::closedSurface::setCurve()
{
    // About the mean: nothing is lost far from the origin
    const nodalVectors x1 =
        basis_->derivative()*(x_.rowwise() - x_.colwise().mean());
    const nodalVectors x2 = basis_->derivative()*x1;

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


void Foam::capsule::closedSurface::setSpatial()
{
    const sphericalGrid& grid = basis_->spherical().grid();
    const label n = coeffs_.rows();
    const nodalVectors a = grid.derivative(0).leftCols(n)*coeffs_;
    const nodalVectors b = grid.derivative(1).leftCols(n)*coeffs_;

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


Foam::capsule::nodalVectors Foam::capsule::closedSurface::secondForm() const
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


Foam::capsule::solvedVector Foam::capsule::closedSurface::integrals
(
    const nodalVectors& f
) const
{
    solvedVector result(f.cols());
    for (label i = 0; i < f.cols(); ++i)
    {
        result(i) = integral(nodalScalars(f.col(i)));
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::closedSurface::closedSurface
(
    const surfaceBasis& basis,
    const nodalVectors& x
)
:
    basis_(&basis),
    x_(x),
    coeffs_
    (
        basis.spatial()
      ? nodalVectors(basis.analysis().topRows(basis.nPacked())*x)
      : nodalVectors(basis.analysis()*x)
    )
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
Foam::capsule::closedSurface::totalCurvature() const
{
    if (!spatial())
    {
        return axisymmetric() ? nodalScalars(kappa_ + secondCurvature_) : kappa_;
    }
    const nodalVectors b = secondForm();
    return
       -b.col(0).cwiseProduct(dot(dual_[0], dual_[0]))
      - 2*b.col(1).cwiseProduct(dot(dual_[0], dual_[1]))
      - b.col(2).cwiseProduct(dot(dual_[1], dual_[1]));
}


Foam::capsule::nodalMatrix
Foam::capsule::closedSurface::curvatureTensor() const
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
            const auto product = [&](const nodalVectors& u, const nodalVectors& v)
            {
                return nodalScalars(u.col(i).cwiseProduct(v.col(j)));
            };
            if (spatial())
            {
                result.col(i*d + j) =
                   -b.col(0).cwiseProduct(product(dual_[0], dual_[0]))
                  - b.col(1).cwiseProduct
                    (
                        product(dual_[0], dual_[1]) + product(dual_[1], dual_[0])
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


Foam::capsule::nodalVectors Foam::capsule::closedSurface::gradient
(
    const nodalScalars& q
) const
{
    if (!spatial())
    {
        return scaled(ds(q), t_);
    }
    return
        scaled(basis_->derivative(0)*q, dual_[0])
      + scaled(basis_->derivative(1)*q, dual_[1]);
}


Foam::capsule::nodalMatrix Foam::capsule::closedSurface::gradients
(
    const nodalVectors& v
) const
{
    const label d = nComponents();
    nodalMatrix result(size(), d*d);
    for (label j = 0; j < d; ++j)
    {
        const nodalVectors g = gradient(nodalScalars(v.col(j)));
        for (label i = 0; i < d; ++i)
        {
            result.col(i*d + j) = g.col(i);
        }
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::closedSurface::along
(
    const nodalVectors& d,
    const nodalVectors& v
) const
{
    if (!spatial())
    {
        return scaled(dot(d, t_), ds(v));
    }
    return
        scaled(dot(d, dual_[0]), basis_->derivative(0)*v)
      + scaled(dot(d, dual_[1]), basis_->derivative(1)*v);
}


Foam::capsule::nodalScalars Foam::capsule::closedSurface::divergence
(
    const nodalVectors& v
) const
{
    if (spatial())
    {
        return
            dot(basis_->derivative(0)*v, dual_[0])
          + dot(basis_->derivative(1)*v, dual_[1]);
    }
    nodalScalars result = dot(ds(v), t_);
    if (axisymmetric())
    {
        result += v.col(1).cwiseQuotient(c_);
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::closedSurface::filtered
(
    const nodalFilter& filter,
    const nodalVectors& v
) const
{
    const nodalScalars normal = filter*dot(v, n_);
    if (spatial())
    {
        return scaled(normal, n_) + tangential(filter*tangential(v));
    }
    return
        scaled(normal, n_) + scaled(nodalScalars(filter*dot(v, t_)), t_);
}


Foam::scalar Foam::capsule::closedSurface::integral(const nodalScalars& f) const
{
    return
        axisymmetric() || spatial()
      ? basis_->weights().dot(areaElement().cwiseProduct(f))
      : basis_->spacing()*g_.dot(f);
}


Foam::capsule::solvedVector Foam::capsule::closedSurface::resultant
(
    const nodalVectors& f
) const
{
    return
        axisymmetric()
      ? solvedVector(vector2(integral(nodalScalars(f.col(0))), 0))
      : integrals(f);
}


Foam::capsule::nodalScalars Foam::capsule::closedSurface::pressureOf
(
    const solvedVector& force
) const
{
    solvedTensor normals(nComponents(), nComponents());
    for (label i = 0; i < nComponents(); ++i)
    {
        normals.row(i) = resultant(scaled(n_.col(i), n_));
    }
    if (axisymmetric())
    {
        // None away from the axis
        normals(1, 1) = 1;
    }
    return n_*(force*normals.inverse()).transpose();
}


Foam::scalar Foam::capsule::closedSurface::moment
(
    const nodalVectors& f,
    const label k
) const
{
    const nodalVectors x = x_.rowwise() - centroid();
    return integral(dot(turned(x, k), f));
}


// ************************************************************************* //
