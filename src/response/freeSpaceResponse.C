/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "freeSpaceResponse.H"
#include "lineResponse.H"
#include "ringResponse.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::freeSpaceResponse::singleLayer
(
    const closedSurface& curve,
    const scalar mu
)
{
    return
        curve.axisymmetric()
      ? ringResponse::singleLayer(curve, mu)
      : lineResponse::singleLayer(curve, mu);
}


Foam::capsule::nodalMatrix Foam::capsule::freeSpaceResponse::adjointDoubleLayer
(
    const closedSurface& curve
)
{
    return
        curve.axisymmetric()
      ? ringResponse::adjointDoubleLayer(curve)
      : lineResponse::adjointDoubleLayer(curve);
}


// ************************************************************************* //
