/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meridianWaves.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::meridianWaves::meridianWaves
(
    const closedSurface& curve
)
:
    n_(curve.basis().nPacked()),
    theta_(n_),
    toCosines_(n_, n_),
    toSines_(n_, n_),
    cosines_(n_),
    sines_(n_)
{
    for (label j = 0; j < n_; ++j)
    {
        theta_(j) = (j + 0.5)*pi/n_;
        for (label k = 0; k < n_; ++k)
        {
            toCosines_(k, j) = (k == 0 ? 1 : 2)*std::cos(k*theta_(j))/n_;
            toSines_(k, j) =
                (k + 1 == n_ ? 1 : 2)*std::sin((k + 1)*theta_(j))/n_;
        }
    }

    const nodalScalars x = curve.nodes().col(0).head(n_);
    axial_ = toCosines_*(x.array() - x.mean()).matrix();
    radial_ = toSines_*curve.around().head(n_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::meridianWaves::place
(
    const label node,
    const scalar offset,
    meridianPoint& point
)
{
    // Half sum and half difference of the parameters of the point and the node
    const scalar half = 0.5*offset;
    const scalar cosSum = std::cos(theta_(node) + half);
    const scalar sinSum = std::sin(theta_(node) + half);
    const scalar cosHalf = std::cos(half);
    const scalar sinHalf = std::sin(half);

    scalar cs = 1, ss = 0, ch = 1, sh = 0;
    scalar dx = 0, dr = 0, r = 0, slopeX = 0, slopeR = 0;
    cosines_(0) = 1;
    for (label k = 1; k <= n_; ++k)
    {
        scalar next = cs*cosSum - ss*sinSum;
        ss = ss*cosSum + cs*sinSum;
        cs = next;
        next = ch*cosHalf - sh*sinHalf;
        sh = sh*cosHalf + ch*sinHalf;
        ch = next;

        const scalar c = cs*ch - ss*sh;
        const scalar s = ss*ch + cs*sh;
        sines_(k - 1) = s;
        r += radial_(k - 1)*s;
        dr -= 2*radial_(k - 1)*cs*sh;
        slopeR += k*radial_(k - 1)*c;
        if (k < n_)
        {
            cosines_(k) = c;
            dx += 2*axial_(k)*ss*sh;
            slopeX -= k*axial_(k)*s;
        }
    }
    point.d = vector2(dx, dr);
    point.r = r;
    return std::hypot(slopeX, slopeR);
}


Foam::capsule::nodalMatrix Foam::capsule::meridianWaves::nodal
(
    const nodalMatrix& waves
) const
{
    nodalMatrix result(2*n_, 2*n_);
    result.leftCols(n_) = waves.leftCols(n_)*toCosines_;
    result.rightCols(n_) = waves.rightCols(n_)*toSines_;
    return result;
}


// ************************************************************************* //
