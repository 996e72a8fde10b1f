/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "neoHookean.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace elasticLaws
{
    defineTypeNameAndDebug(neoHookean, 0);
    addToRunTimeSelectionTable(elasticLaw, neoHookean, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::neoHookean::neoHookean(const dictionary& dict)
:
    elasticLaw(dict),
    shearModulus_(modulus(dict, "shearModulus"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::neoHookean::tension
(
    const nodalScalars& stretch
) const
{
    return shearModulus_*(stretch.array().square() - 1).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::neoHookean::energy
(
    const nodalScalars& stretch
) const
{
    return
        shearModulus_
       *(stretch.array().cube()/3 - stretch.array() + scalar(2)/3);
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::neoHookean::stiffness
(
    const nodalScalars& stretch
) const
{
    return 2*shearModulus_*stretch;
}
