/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "polarRule.H"
#include "GaussRule.H"
#include "sphericalGrid.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::polarRule::polarRule(const sphericalHarmonics& harmonics)
:
    degree_(harmonics.degree()),
    polar_(degree_ + 1),
    rotation_(degree_ + 1)
{
    const label q = (5*degree_ + 7)/4;
    const label around = 2*q + 2;
    const GaussRule Gauss(q + 1);

    waves_ = waves(degree_, around);
    weights_.resize((q + 1)*around);
    for (label m = 0; m <= degree_; ++m)
    {
        polar_[m].resize(q + 1, degree_ + 1 - m);
    }
    for (label j = 0; j <= q; ++j)
    {
        const scalar theta = 0.5*pi*(1 + Gauss.node(j));
        weights_.segment(j*around, around).setConstant
        (
            sqr(pi)/around*std::sin(theta)*Gauss.weight(j)
        );
        const nodalScalars Y =
            harmonics.values(vector(std::sin(theta), 0, std::cos(theta)));
        for (label m = 0; m <= degree_; ++m)
        {
            for (label l = m; l <= degree_; ++l)
            {
                polar_[m](j, l - m) = Y(l*l + max(2*m - 1, label(0)));
            }
        }
    }

    const sphericalGrid grid(harmonics, degree_, 0);
    nodalMatrix exchanged(harmonics.size(), grid.size());
    forAll(grid.nodes(), i)
    {
        const vector& y = grid.nodes()[i];
        exchanged.col(i) = harmonics.values(vector(y.y(), y.z(), y.x()));
    }
    exchange_ = grid.analysis()*exchanged.transpose();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::polarRule::setPole(const scalar theta)
{
    // The axes y, z, x after the exchange are x, y, z before
    const nodalMatrix between = turned(exchange_, theta);
    for (label l = 0; l <= degree_; ++l)
    {
        const label n = 2*l + 1;
        rotation_[l] =
            exchange_.block(l*l, l*l, n, n).transpose()
           *between.block(l*l, l*l, n, n);
    }
}


Foam::capsule::nodalMatrix Foam::capsule::polarRule::values
(
    const nodalMatrix& coefficients
) const
{
    const label nFields = coefficients.cols();
    nodalMatrix rotated(coefficients.rows(), nFields);
    for (label l = 0; l <= degree_; ++l)
    {
        rotated.middleRows(l*l, 2*l + 1).noalias() =
            rotation_[l]*coefficients.middleRows(l*l, 2*l + 1);
    }

    // Around the pole, for each field and angle
    nodalMatrix parts(nAngles()*nFields, 2*degree_ + 1);
    for (label i = 0; i <= 2*degree_; ++i)
    {
        const label m = order(i);
        nodalMatrix ofOrder(degree_ + 1 - m, nFields);
        for (label l = m; l <= degree_; ++l)
        {
            ofOrder.row(l - m) = rotated.row(l*l + i);
        }
        Eigen::Map<nodalMatrix>(parts.col(i).data(), nAngles(), nFields)
            .noalias() = polar_[m]*ofOrder;
    }

    nodalMatrix result(size(), nFields);
    Eigen::Map<nodalMatrix>(result.data(), waves_.rows(), parts.rows())
        .noalias() = waves_*parts.transpose();
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::polarRule::sums
(
    const nodalMatrix& fields
) const
{
    const label nFields = fields.cols();
    const label nRows = nAngles()*nFields;
    nodalMatrix parts(nRows, 2*degree_ + 1);
    parts.noalias() =
        Eigen::Map<const nodalMatrix>(fields.data(), waves_.rows(), nRows)
       .transpose()*waves_;

    nodalMatrix result(sphericalHarmonics::size(degree_), nFields);
    for (label i = 0; i <= 2*degree_; ++i)
    {
        const label m = order(i);
        const nodalMatrix ofOrder =
            polar_[m].transpose()
           *Eigen::Map<const nodalMatrix>
            (
                parts.col(i).data(), nAngles(), nFields
            );
        for (label l = m; l <= degree_; ++l)
        {
            result.row(l*l + i) = ofOrder.row(l - m);
        }
    }

    for (label l = 0; l <= degree_; ++l)
    {
        const label n = 2*l + 1;
        result.middleRows(l*l, n) =
            (rotation_[l].transpose()*result.middleRows(l*l, n)).eval();
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::polarRule::turned
(
    const nodalMatrix& coefficients,
    const scalar angle
)
{
    nodalMatrix result = coefficients;
    for (label m = 1; m*m < result.rows(); ++m)
    {
        const scalar c = std::cos(m*angle);
        const scalar s = std::sin(m*angle);
        for (label l = m; l*l < result.rows(); ++l)
        {
            const label i = l*l + 2*m - 1;
            result.row(i) =
                c*coefficients.row(i) + s*coefficients.row(i + 1);
            result.row(i + 1) =
                c*coefficients.row(i + 1) - s*coefficients.row(i);
        }
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::polarRule::waves
(
    const label order,
    const label nPoints
)
{
    nodalMatrix result(nPoints, 2*order + 1);
    for (label k = 0; k < nPoints; ++k)
    {
        result(k, 0) = 1;
        for (label m = 1; m <= order; ++m)
        {
            result(k, 2*m - 1) = std::cos(2*pi*m*k/nPoints);
            result(k, 2*m) = std::sin(2*pi*m*k/nPoints);
        }
    }
    return result;
}


// ************************************************************************* //
