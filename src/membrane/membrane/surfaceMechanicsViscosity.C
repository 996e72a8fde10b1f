/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceMechanics.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::surfaceMechanics::metricHistory
Foam::capsule::surfaceMechanics::historyOn(const sphericalGrid& grid) const
{
    const surfaceMetric last = metricOf(grid, old_[0]);
    const surfaceMetric lastButOne = metricOf(grid, old_[1]);

    metricHistory result;
    for (label i = 0; i < 3; ++i)
    {
        result[i] = scheme_.history
        (
            last.metric(i/2, (i + 1)/2), lastButOne.metric(i/2, (i + 1)/2)
        );
    }
    return result;
}


Foam::capsule::surfaceMetric::tensor2 Foam::capsule::surfaceMechanics::at
(
    const metricHistory& history,
    const label node
)
{
    surfaceMetric::tensor2 result;
    result <<
        history[0](node), history[1](node),
        history[1](node), history[2](node);
    return result;
}


void Foam::capsule::surfaceMechanics::addViscousTensions
(
    const sphericalGrid& grid,
    const surfaceMetric& reference,
    const surfaceMetric& surface,
    principalValues& values
) const
{
    // With the mixed tensors b = A^ac a_cb, of principal values l1^2 and l2^2,
    // and t = T^ac a_cb: tr(b t) = l1^2 T1 + l2^2 T2, tr t = T1 + T2
    typedef surfaceMetric::tensor2 tensor2;
    const metricHistory history = historyOn(grid);

    for (label k = 0; k < grid.size(); ++k)
    {
        const surfaceMetric::vectorPair x = surface.tangentsAt(k);
        const tensor2 metric = x.transpose()*x;
        const tensor2 t =
            viscosity_->stress
            (
                surface.inverseAt(k), at(history, k), scheme_.c
            )
           *metric;
        const scalar trace = t.trace();
        const scalar square1 = sqr(values.l1(k));
        const scalar square2 = sqr(values.l2(k));
        const scalar moment = (reference.inverseAt(k)*metric*t).trace();

        // Equal stretches have no directions: the mean tension then
        const scalar T1 =
            square1 - square2 > 1e-6*square1
          ? (moment - square2*trace)/(square1 - square2)
          : 0.5*trace;
        values.T1(k) += T1;
        values.T2(k) += trace - T1;
    }
}


void Foam::capsule::surfaceMechanics::addViscousForce
(
    const surfaceMetric& surface,
    nodalVectors& force
) const
{
    const metricHistory history = historyOn(grid_);
    nodalVectors resultants[2];
    resultants[0] = resultants[1] = nodalVectors::Zero(grid_.size(), 3);

    for (label k = 0; k < grid_.size(); ++k)
    {
        const surfaceMetric::vectorPair r =
            surface.tangentsAt(k)
           *viscosity_->stress
            (
                surface.inverseAt(k), at(history, k), scheme_.c
            );
        for (label a = 0; a < 2; ++a)
        {
            resultants[a].row(k) =
                grid_.weights()(k)*surface.area()(k)/(-4*pi)
               *r.col(a).transpose();
        }
    }
    for (label a = 0; a < 2; ++a)
    {
        force += grid_.derivative(a).transpose()*resultants[a];
    }
}


void Foam::capsule::surfaceMechanics::addViscous
(
    const nodalVectors& X,
    const bool fullTangent,
    List<nodalMatrix>& fields
) const
{
    const label nDerivatives = products_.nDerivatives();
    const surfaceMetric surface = metricOf(grid_, X);
    const metricHistory history = historyOn(grid_);

    for (label k = 0; k < grid_.size(); ++k)
    {
        const surfaceViscosity::pairDerivative d = viscosity_->derivative
        (
            surface, k, at(history, k), scheme_.c, fullTangent
        );

        for (label bc = 0; bc < 4; ++bc)
        {
            for (label ij = 0; ij < 9; ++ij)
            {
                fields[ij](k, bc/2*nDerivatives + bc % 2) +=
                    grid_.weights()(k)
                   *d(3*(bc/2) + ij/3, 3*(bc % 2) + ij % 3);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::surfaceMechanics::setRates
(
    const timeScheme& scheme,
    const nodalVectors& last,
    const nodalVectors& lastButOne
)
{
    scheme_ = scheme;
    old_[0] = last;
    old_[1] = lastButOne;
}


// ************************************************************************* //
