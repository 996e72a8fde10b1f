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


//- Value and gradient at the origin, of one polynomial and of each
typedef Eigen::Matrix<scalar, Eigen::Dynamic, 1, 0, 4, 1> fitColumn;
typedef Eigen::Matrix<scalar, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 20>
    ofMonomials;


//- Monomials up to the third degree, in order, at points: 10, in space 20
static nodalMatrix monomials(const nodalVectors& points)
{
    const label d = points.cols();
    nodalMatrix result(points.rows(), d == 2 ? 10 : 20);
    result.col(0).setOnes();

    // Each of the last degree, whose last variable is given, times that and
    // those after it
    label last[20] = {0};
    label first = 0;
    label n = 1;
    for (label degree = 1; degree <= 3; ++degree)
    {
        const label end = n;
        for (; first < end; ++first)
        {
            for (label i = last[first]; i < d; ++i)
            {
                last[n] = i;
                result.col(n) = result.col(first).cwiseProduct(points.col(i));
                ++n;
            }
        }
    }
    return result;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::capsule::fitRows Foam::capsule::cubicFit
(
    const nodalVectors& points,
    const nodalScalars& weights
)
{
    const label n = points.rows();
    const label linear = 1 + points.cols();
    nodalMatrix basis = monomials(points);
    basis.array().colwise() *= weights.array();
    const label nMonomials = basis.cols();

    // Gram-Schmidt: orthonormal columns, and value and gradient at the origin of
    // their polynomials, times the part of each that counts
    nodalScalars q(n);
    ofMonomials origin(linear, nMonomials);
    ofMonomials counted(linear, nMonomials);
    label kept = 0;

    for (label j = 0; j < nMonomials; ++j)
    {
        q = basis.col(j);
        fitColumn atOrigin(fitColumn::Zero(linear));
        if (j < linear)
        {
            atOrigin(j) = 1;
        }
        const scalar size = q.norm();
        scalar own = size;
        scalar before;
        do
        {
            // Again where little is left: much of that is round-off
            before = own;
            for (label k = 0; k < kept; ++k)
            {
                const scalar along = basis.col(k).dot(q);
                q -= along*basis.col(k);
                atOrigin -= along*origin.col(k);
            }
            own = q.norm();
        } while (own < 0.1*before && own > 1e-6*size);
        if (own <= 1e-6*size)
        {
            if (j < linear)
            {
                // Not even a gradient
                return fitRows(linear, 0);
            }
            continue;
        }
        basis.col(kept) = q/own;
        origin.col(kept) = atOrigin/own;
        counted.col(kept) =
            (j < linear ? 1 : min(sqr(own/distinct), scalar(1)))
           *origin.col(kept);
        ++kept;
    }

    fitRows rows(linear, n);
    for (label i = 0; i < linear; ++i)
    {
        rows.row(i) =
            basis.leftCols(kept)*counted.row(i).head(kept).transpose();
    }
    return rows*weights.asDiagonal();
}


// ************************************************************************* //
