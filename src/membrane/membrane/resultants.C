/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "resultants.H"
#include "byColumns.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::resultants::force
(
    const closedSurface& curve,
    const nodalVectors& R
)
{
    const nodalMatrix& d = curve.basis().derivative();
    if (!curve.axisymmetric())
    {
        return byColumns(d, R);
    }
    const nodalScalars dc =
        curve.metric().cwiseProduct(curve.tangent().col(1));

    return scaled(curve.around(), byColumns(d, R)) + scaled(dc, R);
}


Foam::capsule::nodalMatrix Foam::capsule::resultants::forceChange
(
    const closedSurface& curve,
    const nodalScalars& R,
    const nodalMatrix& dR,
    const label j
)
{
    const nodalMatrix& d = curve.basis().derivative();
    nodalMatrix result = curve.metric().cwiseInverse().asDiagonal()*(d*dR);
    if (!curve.axisymmetric())
    {
        return result;
    }
    result += curve.convergence().asDiagonal()*dR;
    if (j == 1)
    {
        // c is the distance from the axis, so its change is that of the nodes
        const nodalScalars perArea = curve.areaElement().cwiseInverse();
        result += perArea.cwiseProduct(R).asDiagonal()*d;
        result.diagonal() += perArea.cwiseProduct(d*R);
    }
    return result;
}
