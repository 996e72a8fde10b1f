/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "curveMechanics.H"
#include "spatialMechanics.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::capsule::membraneMechanics>
Foam::capsule::membraneMechanics::New
(
    const dictionary& dict,
    const surfaceBasis& basis
)
{
    if (basis.spatial())
    {
        return autoPtr<membraneMechanics>
        (
            new spatialMechanics(dict, basis.spherical())
        );
    }
    return autoPtr<membraneMechanics>
    (
        new curveMechanics(dict, !basis.axisymmetric())
    );
}


// ************************************************************************* //
