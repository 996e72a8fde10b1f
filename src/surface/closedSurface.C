/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "closedSurface.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
