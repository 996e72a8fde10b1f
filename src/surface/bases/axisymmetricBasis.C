/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.


\*---------------------------------------------------------------------------*/

#include "axisymmetricBasis.H"
#include "error.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::axisymmetricBasis::axisymmetricBasis
(
    const label n,
    const scalar axis
)
:
    curveBasis(n),
    axis_(axis)
{
    if (n % 2)
    {
        FatalErrorInFunction
            << "A surface of revolution needs an even number of points, not "
            << n << abort(FatalError);
    }

    // r f g = Sum_k b_k sin k theta has the integral Sum 2 b_k/k, k odd; once
    // around is 2 pi, shared by the two halves, on one of which r is negative
    const label half = nPacked();
    for (label j = 0; j < half; ++j)
    {
        const scalar theta = (j + 0.5)*spacing();
        scalar sum = 0;
        for (label k = 1; k <= half; k += 2)
        {
            sum += (k < half ? 2 : 1)*2*std::sin(k*theta)/(half*scalar(k));
        }
        weights_(j) = pi*sum;
        weights_(n - 1 - j) = -pi*sum;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::axisymmetricBasis::folded
(
    const nodalMatrix& m,
    const label component
) const
{
    // Rows of the nodes that count; columns of mirror images added to theirs
    const label n = nPacked();

    return
        m.topLeftCorner(n, n)
      + (component == 0 ? 1 : -1)*m.topRightCorner(n, n).rowwise().reverse();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::axisymmetricBasis::pack
(
    const nodalVectors& v
) const
{
    const label n = nPacked();
    nodalScalars result(2*n);
    result << v.col(0).head(n), v.col(1).head(n);
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::axisymmetricBasis::extended
(
    const nodalScalars& f,
    const bool even
) const
{
    nodalScalars result(size());
    result << f, (even ? 1 : -1)*f.reverse();
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::axisymmetricBasis::unpack
(
    const nodalScalars& v
) const
{
    const label n = nPacked();
    nodalVectors result(2*n, 2);
    result.col(0) = extended(v.head(n), true);
    result.col(1) = extended(v.tail(n), false);
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::axisymmetricBasis::reduced
(
    const nodalFilter& filter,
    const label component
) const
{
    return folded(curveBasis::reduced(filter, component), component);
}


Foam::capsule::nodalMatrix Foam::capsule::axisymmetricBasis::reduced
(
    const nodalMatrix& m
) const
{
    const label n = nPacked();
    nodalMatrix result(2*n, 2*n);
    for (label i = 0; i < 2; ++i)
    {
        for (label j = 0; j < 2; ++j)
        {
            result.block(i*n, j*n, n, n) =
                folded(m.block(i*2*n, j*2*n, 2*n, 2*n), j);
        }
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::axisymmetricBasis::symmetric
(
    const nodalVectors& x
) const
{
    nodalVectors relative(x);
    relative.col(1).array() -= axis_;
    relative = unpack(pack(relative));
    relative.col(1).array() += axis_;
    return relative;
}


// ************************************************************************* //
