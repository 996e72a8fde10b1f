/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "noTension.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace elasticLaws
{
    defineTypeNameAndDebug(noTension, 0);
    addToRunTimeSelectionTable(elasticLaw, noTension, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::noTension::tension
(
    const nodalScalars& l1,
    const nodalScalars&
) const
{
    return nodalScalars::Zero(l1.size());
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::noTension::energy
(
    const nodalScalars& l1,
    const nodalScalars&
) const
{
    return nodalScalars::Zero(l1.size());
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::noTension::stiffness
(
    const nodalScalars& l1,
    const nodalScalars&
) const
{
    return nodalScalars::Zero(l1.size());
}


Foam::capsule::nodalScalars
Foam::capsule::elasticLaws::noTension::crossStiffness
(
    const nodalScalars& l1,
    const nodalScalars&
) const
{
    return nodalScalars::Zero(l1.size());
}


Foam::capsule::secondPiolaStress Foam::capsule::elasticLaws::noTension::stress
(
    const nodalScalars&,
    const nodalScalars& J
) const
{
    return secondPiolaStress(J.size());
}
