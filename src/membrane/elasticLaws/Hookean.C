/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "Hookean.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace elasticLaws
{
    defineTypeNameAndDebug(Hookean, 0);
    addToRunTimeSelectionTable(elasticLaw, Hookean, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::Hookean::Hookean(const dictionary& dict)
:
    elasticLaw(dict),
    modulus_(modulus(dict, "elasticModulus"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Hookean::tension
(
    const nodalScalars& stretch
) const
{
    return (modulus_*(stretch.array() - 1)).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Hookean::energy
(
    const nodalScalars& stretch
) const
{
    return
        0.5*modulus_*(stretch.array() - 1).square();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Hookean::stiffness
(
    const nodalScalars& stretch
) const
{
    return nodalScalars::Constant(stretch.size(), modulus_);
}
