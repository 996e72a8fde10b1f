/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "immersedMembrane.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::closedCurve Foam::capsule::immersedMembrane::moved
(
    const nodalVectors& U
) const
{
    return closedCurve(body_.basis(), motion_->points(motion_->velocity(U)));
}


Foam::scalar Foam::capsule::immersedMembrane::cells(const nodalScalars& U) const
{
    const nodalVectors d = unstacked(motion_->displacements(U));

    return d.rowwise().norm().maxCoeff()/distance().width();
}


void Foam::capsule::immersedMembrane::linearise
(
    const closedCurve& at,
    const bool whole
)
{
    // Forces are per length of the step's interface
    const nodalScalars length =
        at.metric().cwiseQuotient(curve().metric()).replicate(2, 1);

    forceJacobian_ = length.asDiagonal()*body_.forceJacobian(at, whole);
    motion_->restoreArea(at, forceJacobian_);
    derivative_.compute(fluid_ - forceJacobian_*displacement_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::immersedMembrane::balance
(
    const nodalScalars& y
) const
{
    const label n = 2*body_.size();

    nodalScalars result = y.tail(y.size() - n);
    result.head(n) += stacked
    (
        implicit_
      ? body_.force(moved(unstacked(y.head(n))), curve().metric())
      : explicitForce_
    );
    return result;
}


void Foam::capsule::immersedMembrane::linearise
(
    const nodalScalars& y,
    const bool whole
)
{
    if (implicit_)
    {
        linearise(moved(unstacked(y.head(2*body_.size()))), whole);
    }
}


Foam::scalar Foam::capsule::immersedMembrane::largestPart
(
    const nodalScalars& dy
) const
{
    return reach_/max(reach_, cells(dy.head(2*body_.size())));
}


Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::balanceChange
(
    const nodalMatrix& dy
) const
{
    const label n = 2*body_.size();

    nodalMatrix result = dy.bottomRows(dy.rows() - n);
    if (implicit_)
    {
        result.topRows(n) += forceJacobian_*motion_->displacements(dy.topRows(n));
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::step
(
    const nodalMatrix& balance
) const
{
    const label n = 2*body_.size();
    const label others = balance.rows() - n;

    nodalMatrix result(balance.rows(), balance.cols());
    result.topRows(n) = derivative_.solve(balance.topRows(n));
    for (label j = 0; others && j < balance.cols(); ++j)
    {
        result.col(j).tail(others) =
            otherStep(result.col(j).head(n), balance.col(j).tail(others));
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::immersedMembrane::answerChange
(
    const nodalScalars& dx
) const
{
    const nodalScalars df = dx.head(2*body_.size());
    const nodalScalars other = otherChange(dx);

    nodalScalars result(2*df.size() + other.size());
    result << velocity_*df, -(fluid_*df), other;
    return result;
}
