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
#include "surfaceResponse.H"
#include "sphericalBasis.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::freeSpaceResponse::singleLayer
(
    const closedSurface& surface,
    const scalar mu
)
{
    if (surface.spatial())
    {
        return surfaceResponse::singleLayer
        (
            surface.basis().spherical().harmonics(), surface.coefficients(), mu
        );
    }
    return
        surface.axisymmetric()
      ? ringResponse::singleLayer(surface, mu)
      : lineResponse::singleLayer(surface, mu);
}


Foam::capsule::nodalMatrix Foam::capsule::freeSpaceResponse::adjointDoubleLayer
(
    const closedSurface& surface
)
{
    if (surface.spatial())
    {
        return surfaceResponse::adjointDoubleLayer
        (
            surface.basis().spherical().harmonics(), surface.coefficients()
        );
    }
    return
        surface.axisymmetric()
      ? ringResponse::adjointDoubleLayer(surface)
      : lineResponse::adjointDoubleLayer(surface);
}


// ************************************************************************* //
