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

Foam::capsule::closedSurface Foam::capsule::immersedMembrane::movedSurface
(
    const nodalVectors& U
) const
{
    return closedSurface(membrane_.basis(), motion_->points(motion_->velocity(U)));
}


Foam::scalar Foam::capsule::immersedMembrane::cells(const nodalScalars& U) const
{
    const nodalVectors d = basis().unpack(motion_->displacements(U));

    return d.rowwise().norm().maxCoeff()/levelSet().width();
}


void Foam::capsule::immersedMembrane::linearise
(
    const closedSurface& at,
    const bool fullTangent
)
{
    nodalMatrix forceJacobian =
        around_.scale()*membrane_.forceJacobian(at, fullTangent);
    if (&at != &surface())
    {
        // Forces are per area of the step's interface
        const nodalScalars area =
            at.areaElement().cwiseQuotient(surface().areaElement());
        const label n = basis().nPacked();
        for (label i = 0; i < basis().nComponents(); ++i)
        {
            forceJacobian.middleRows(i*n, n) =
                basis().multiplied(area, forceJacobian.middleRows(i*n, n));
        }
    }
    motion_->restoreVolume(at, forceJacobian);
    tangent_.linearise(forceJacobian);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::immersedMembrane::residual
(
    const nodalScalars& y
) const
{
    const label n = nForce();

    nodalScalars result = y.tail(y.size() - n);
    result.head(n) += basis().pack
    (
        implicit_
      ? force(movedSurface(basis().unpack(y.head(n))))
      : explicitForce_
    );
    return result;
}


void Foam::capsule::immersedMembrane::linearise
(
    const nodalScalars& y,
    const bool fullTangent
)
{
    if (implicit_)
    {
        linearise(movedSurface(basis().unpack(y.head(nForce()))), fullTangent);
    }
}


Foam::scalar Foam::capsule::immersedMembrane::maxStepLength
(
    const nodalScalars& dy
) const
{
    return maxMove_/max(maxMove_, cells(dy.head(nForce())));
}


Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::residualChange
(
    const nodalMatrix& dy
) const
{
    const label n = nForce();

    nodalMatrix result = dy.bottomRows(dy.rows() - n);
    if (implicit_)
    {
        result.topRows(n) +=
            tangent_.forceChange(motion_->displacements(dy.topRows(n)));
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::correction
(
    const nodalMatrix& residual
) const
{
    const label n = nForce();
    const label others = residual.rows() - n;

    nodalMatrix result(residual.rows(), residual.cols());
    for (label j = 0; j < residual.cols(); ++j)
    {
        // One by one: they are few
        result.col(j).head(n) =
            tangent_.correction(residual.col(j).head(n));
        if (others)
        {
            result.col(j).tail(others) = inertiaCorrection
            (
                result.col(j).head(n), residual.col(j).tail(others)
            );
        }
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::immersedMembrane::responseChange
(
    const nodalScalars& dx
) const
{
    const nodalScalars df = dx.head(nForce());
    const nodalScalars other = inertiaResidualChange(dx);

    nodalScalars result(2*df.size() + other.size());
    result << mobility()*df, tangent_.restChange(df), other;
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::immersedMembrane::pointsOf
(
    const nodalScalars& y
) const
{
    return motion_->points(motion_->velocity(basis().unpack(y.head(nForce()))));
}


Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::pointsChange
(
    const nodalMatrix& dy
) const
{
    return motion_->displacements(dy.topRows(nForce()));
}


Foam::capsule::nodalMatrix Foam::capsule::immersedMembrane::loaded
(
    const nodalMatrix& forces
) const
{
    nodalMatrix result = nodalMatrix::Zero(nUnknowns(), forces.cols());
    result.topRows(nForce()) = around_.scale()*forces;
    return result;
}
