/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceTension.H"
#include "familyEntries.H"
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
    static const familyEntries<elasticLaw> entries({"surfaceTension"});
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::surfaceTension::surfaceTension
(
    const dictionary& dict,
    const bool
)
:
    elasticLaw(dict),
    surfaceTension_(modulus(dict, "surfaceTension"))
{}


Foam::capsule::elasticLaws::surfaceTension::surfaceTension
(
    const dictionary& dict,
    const scalar tension
)
:
    elasticLaw(dict),
    surfaceTension_(tension)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::surfaceTension::tension
(
    const nodalScalars& l1,
    const nodalScalars&
) const
{
    return nodalScalars::Constant(l1.size(), surfaceTension_);
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::surfaceTension::energy
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return surfaceTension_*l1.cwiseProduct(l2);
}


Foam::capsule::nodalScalars
Foam::capsule::elasticLaws::surfaceTension::stiffness
(
    const nodalScalars& l1,
    const nodalScalars&
) const
{
    return nodalScalars::Zero(l1.size());
}


Foam::capsule::nodalScalars
Foam::capsule::elasticLaws::surfaceTension::crossStiffness
(
    const nodalScalars& l1,
    const nodalScalars&
) const
{
    return nodalScalars::Zero(l1.size());
}


Foam::capsule::secondPiolaStress
Foam::capsule::elasticLaws::surfaceTension::stress
(
    const nodalScalars&,
    const nodalScalars& J
) const
{
    // W = T J
    secondPiolaStress result(J.size());
    result.beta = surfaceTension_*J;
    result.betaJ.setConstant(surfaceTension_);

    return result;
}
