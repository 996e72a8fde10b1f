/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "inextensible.H"
#include "familyEntries.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace elasticLaws
{
    defineTypeNameAndDebug(inextensible, 0);
    addToRunTimeSelectionTable(elasticLaw, inextensible, dictionary);
    static const familyEntries<elasticLaw> entries
    (
        {"areaModulus", "shearModulus", "largestStrain"}
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::inextensible::inextensible
(
    const dictionary& dict,
    const bool
)
:
    elasticLaw(dict),
    areaModulus_(modulus(dict, "areaModulus")),
    shearModulus_
    (
        dict.found("shearModulus") ? modulus(dict, "shearModulus") : 0
    ),
    largestStrain_
    (
        input::getBetweenOrDefault<scalar>
        (
            dict, "largestStrain", 1e-3, 1e-6, 1
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::inextensible::tension
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return
    (
        areaModulus_*(l1.array()*l2.array() - 1)
      + 0.5*shearModulus_*(l2.array().pow(-2) - l1.array().pow(-2))
    ).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::inextensible::energy
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    const auto J = l1.array()*l2.array();

    return
    (
        0.5*areaModulus_*(J - 1).square()
      + 0.5*shearModulus_*(l1.array() - l2.array()).square()/J
    ).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::inextensible::stiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return areaModulus_*l2 + (shearModulus_*l1.array().pow(-3)).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::inextensible::crossStiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return areaModulus_*l1 - (shearModulus_*l2.array().pow(-3)).matrix();
}


Foam::capsule::secondPiolaStress
Foam::capsule::elasticLaws::inextensible::stress
(
    const nodalScalars& I,
    const nodalScalars& J
) const
{
    // alpha = G/J, beta = K J (J - 1) - G I/(2 J)
    secondPiolaStress result(J.size());
    result.alpha = shearModulus_*J.cwiseInverse();
    result.alphaJ = -shearModulus_*J.array().pow(-2);
    result.beta =
        areaModulus_*J.array()*(J.array() - 1)
      - 0.5*shearModulus_*I.array()/J.array();
    result.betaI = -0.5*shearModulus_*J.cwiseInverse();
    result.betaJ =
        areaModulus_*(2*J.array() - 1)
      + 0.5*shearModulus_*I.array()*J.array().pow(-2);

    return result;
}
