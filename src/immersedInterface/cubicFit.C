/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.


\*---------------------------------------------------------------------------*/

#include "cubicFit.H"
#include "label.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Norm over the weighted cells, in cell widths, below which a monomial's part
//  that is orthogonal to those before it is diminished
static const scalar distinct = 0.3;

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Eigen::Matrix<Foam::scalar, 3, Eigen::Dynamic>
Foam::capsule::cubicFit
(
    const nodalVectors& points,
    const nodalScalars& weights
)
{
    const label n = points.rows();
    Eigen::Matrix<scalar, Eigen::Dynamic, 10> basis(n, 10);
    for (label i = 0; i < n; ++i)
    {
        const scalar x = points(i, 0);
        const scalar y = points(i, 1);
        basis.row(i) <<
            1, x, y, sqr(x), x*y, sqr(y),
            pow3(x), sqr(x)*y, x*sqr(y), pow3(y);
    }
    basis = weights.asDiagonal()*basis;

    // Gram-Schmidt, twice: orthonormal columns, and value and gradient at the
    // origin of their polynomials
    Eigen::Matrix<scalar, 3, Eigen::Dynamic> rows =
        Eigen::Matrix<scalar, 3, Eigen::Dynamic>::Zero(3, n);
    Eigen::Matrix<scalar, 3, 10> origin(Eigen::Matrix<scalar, 3, 10>::Zero());
    origin.leftCols<3>().setIdentity();
    label kept = 0;
    for (label j = 0; j < 10; ++j)
    {
        nodalScalars q = basis.col(j);
        Eigen::Matrix<scalar, 3, 1> atOrigin = origin.col(j);
        const scalar size = q.norm();
        for (label pass = 0; pass < 2; ++pass)
        {
            for (label k = 0; k < kept; ++k)
            {
                const scalar along = basis.col(k).dot(q);
                q -= along*basis.col(k);
                atOrigin -= along*origin.col(k);
            }
        }
        const scalar own = q.norm();
        if (own < 1e-6*size)
        {
            if (j < 3)
            {
                // Not even a gradient
                return Eigen::Matrix<scalar, 3, Eigen::Dynamic>(3, 0);
            }
            continue;
        }
        basis.col(kept) = q/own;
        origin.col(kept) = atOrigin/own;
        const scalar part = (j < 3 ? 1 : min(sqr(own/distinct), scalar(1)));
        rows += part*origin.col(kept)*basis.col(kept).transpose();
        ++kept;
    }
    return rows*weights.asDiagonal();
}


// ************************************************************************* //
