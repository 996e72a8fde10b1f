/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "Skalak.H"
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
