/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.
\*---------------------------------------------------------------------------*/

#include "immersedMembrane.H"
#include "timeScheme.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using namespace Foam;
    using namespace Foam::capsule;

    //- Derivative of the area by the points of a curve, components stacked
    Eigen::Matrix<scalar, 1, Eigen::Dynamic> areaDerivative
    (
        const closedCurve& curve
    )
    {
        return
            curve.basis().spacing()
           *stacked(scaled(curve.metric(), curve.normal())).transpose();
    }

    //- Displacement along the normal that changes the area by one
    nodalScalars shift(const closedCurve& curve)
    {
        return stacked(curve.normal())/curve.perimeter();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::displacements
(
    const nodalMatrix& U
) const
{
    const timeScheme scheme(mesh_, "ddt(membranes)", body_.nOld());
    const label n = body_.size();

    nodalMatrix result(2*n, U.cols());
    result << moving_*U.topRows(n), moving_*U.bottomRows(n);
    if (conserveArea_)
    {
        result -= shift(curve())*(areaDerivative(curve())*result);
    }
    return result/scheme.c;
}


Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::force
(
    const nodalVectors& U
) const
{
    return
        implicit_
      ? body_.force
        (
            closedCurve(body_.basis(), moved(motion(U))),
            curve().metric()
        )
      : explicitForce_;
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
    if (conserveArea_)
    {
        forceJacobian_ -= (forceJacobian_*shift(at))*areaDerivative(at);
    }
    balance_.compute(fluid_ - forceJacobian_*displacement_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::immersedMembrane::balance
(
    const nodalScalars& y
) const
{
    const label n = 2*body_.size();

    nodalScalars result = y.tail(y.size() - n);
    result.head(n) += stacked(force(unstacked(y.head(n))));
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
        const nodalVectors U = unstacked(y.head(2*body_.size()));
        linearise(closedCurve(body_.basis(), moved(motion(U))), whole);
    }
}


Foam::scalar Foam::capsule::immersedMembrane::largestPart
(
    const nodalScalars& dy
) const
{
    const nodalVectors d =
        unstacked(displacements(dy.head(2*body_.size())));
    const scalar cells =
        d.rowwise().norm().maxCoeff()/distance().width();

    return cells > reach_ ? reach_/cells : 1;
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
        result.topRows(n) += forceJacobian_*displacements(dy.topRows(n));
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
    result.topRows(n) = balance_.solve(balance.topRows(n));
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
