/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphericalGrid.H"
#include "GaussRule.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sphericalGrid::sphericalGrid
(
    const sphericalHarmonics& harmonics,
    const label degree,
    const label order
)
:
    degree_(degree),
    nodes_(2*sphericalHarmonics::size(degree)),
    weights_(nodes_.size()),
    values_(nodes_.size(), harmonics.size())
{
    for (label i = 0; i < 2 && order > 0; ++i)
    {
        first_[i].resize(values_.rows(), values_.cols());
    }
    for (label i = 0; i < 3 && order > 1; ++i)
    {
        second_[i].resize(values_.rows(), values_.cols());
    }

    const label nAround = 2*degree + 2;
    const GaussRule rule(degree + 1);
    for (label k = 0; k < nodes_.size(); ++k)
    {
        const label circle = degree - k/nAround;
        const scalar z = rule.node(circle);
        const scalar s = std::sqrt((1 - z)*(1 + z));
        const scalar phi = 2*pi*(k % nAround)/nAround;
        const vector around(-std::sin(phi), std::cos(phi), 0);
        const vector outward(around.y(), -around.x(), 0);

        nodes_[k] = s*outward + vector(0, 0, z);
        weights_(k) = 2*pi/nAround*rule.weight(circle);
        if (order == 0)
        {
            values_.row(k) = harmonics.values(nodes_[k]).transpose();
            continue;
        }

        const vector south = z*outward - vector(0, 0, s);
        const auto parts = harmonics.expansion(nodes_[k], south, around);
        values_.row(k) = parts.col(0).transpose();
        first_[0].row(k) = parts.col(1).transpose();
        first_[1].row(k) = parts.col(2).transpose();
        if (order > 1)
        {
            // From covariant derivatives: circles phi are geodesics, circles
            // theta are not
            const scalar cotangent = z/s;
            second_[0].row(k) = parts.col(3).transpose();
            second_[1].row(k) =
                (parts.col(4) + cotangent*parts.col(2)).transpose();
            second_[2].row(k) =
                (parts.col(5) - cotangent*parts.col(1)).transpose();
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::sphericalGrid::analysis() const
{
    return values_.transpose()*weights_.asDiagonal()/(4*pi);
}


// ************************************************************************* //
