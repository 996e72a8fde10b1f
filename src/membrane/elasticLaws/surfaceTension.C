/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceTension.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace elasticLaws
{
    defineTypeNameAndDebug(surfaceTension, 0);
    addToRunTimeSelectionTable(elasticLaw, surfaceTension, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::surfaceTension::surfaceTension(const dictionary& dict)
:
    elasticLaw(dict),
    surfaceTension_(modulus(dict, "surfaceTension"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::surfaceTension::tension
(
    const nodalScalars& stretch
) const
{
    return nodalScalars::Constant(stretch.size(), surfaceTension_);
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::surfaceTension::energy
(
    const nodalScalars& stretch
) const
{
    return
        surfaceTension_*stretch;
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::surfaceTension::stiffness
(
    const nodalScalars& stretch
) const
{
    return nodalScalars::Zero(stretch.size());
}
