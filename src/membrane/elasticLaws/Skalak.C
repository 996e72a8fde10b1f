/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "Skalak.H"
#include "familyEntries.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace elasticLaws
{
    defineTypeNameAndDebug(Skalak, 0);
    addToRunTimeSelectionTable(elasticLaw, Skalak, dictionary);
    static const familyEntries<elasticLaw> entries({"shearModulus", "C"});
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::Skalak::Skalak
(
    const dictionary& dict,
    const bool
)
:
    elasticLaw(dict),
    shearModulus_(modulus(dict, "shearModulus")),
    C_(input::getBetween<scalar>(dict, "C", -0.49, input::largest))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Skalak::tension
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    const auto J = l1.array()*l2.array();

    return
        shearModulus_
       *(
            l1.array()*(l1.array().square() - 1)/l2.array()
          + C_*J*(J.square() - 1)
        ).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Skalak::energy
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    const nodalScalars I1 =
        (l1.array().square() + l2.array().square() - 2).matrix();
    const nodalScalars I2 = ((l1.array()*l2.array()).square() - 1).matrix();

    return
        0.25*shearModulus_
       *(I1.cwiseAbs2() + 2*I1 - 2*I2 + C_*I2.cwiseAbs2());
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Skalak::stiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    const auto J = l1.array()*l2.array();

    return
        shearModulus_
       *(
            (3*l1.array().square() - 1)/l2.array()
          + C_*l2.array()*(3*J.square() - 1)
        ).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Skalak::crossStiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    const auto J = l1.array()*l2.array();

    return
        shearModulus_
       *(
            C_*l1.array()*(3*J.square() - 1)
          - l1.array()*(l1.array().square() - 1)/l2.array().square()
        ).matrix();
}


Foam::capsule::secondPiolaStress Foam::capsule::elasticLaws::Skalak::stress
(
    const nodalScalars& I,
    const nodalScalars& J
) const
{
    // alpha = G (I - 1), beta = G J^2 (C (J^2 - 1) - 1)
    const nodalScalars J2 = J.cwiseAbs2();

    secondPiolaStress result(J.size());
    result.alpha = shearModulus_*(I.array() - 1);
    result.beta = shearModulus_*J2.array()*(C_*(J2.array() - 1) - 1);
    result.alphaI.setConstant(shearModulus_);
    result.betaJ = 2*shearModulus_*J.array()*(C_*(2*J2.array() - 1) - 1);

    return result;
}
