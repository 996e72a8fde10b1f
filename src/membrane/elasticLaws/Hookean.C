/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "Hookean.H"
#include "familyEntries.H"
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
    static const familyEntries<elasticLaw> entries
    (
        {"elasticModulus", "poissonRatio"}
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::Hookean::Hookean
(
    const dictionary& dict,
    const bool plane
)
:
    elasticLaw(dict),
    modulus_(modulus(dict, "elasticModulus")),
    ratio_(0)
{
    if (!plane || dict.found("poissonRatio"))
    {
        ratio_ = input::getBetween<scalar>(dict, "poissonRatio", -0.99, 0.99);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Hookean::tension
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return
    (
        modulus_*((l1.array() - 1) + ratio_*(l2.array() - 1))/l2.array()
    ).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Hookean::energy
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    const auto e1 = l1.array() - 1;
    const auto e2 = l2.array() - 1;

    return 0.5*modulus_*(e1.square() + e2.square() + 2*ratio_*e1*e2).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Hookean::stiffness
(
    const nodalScalars&,
    const nodalScalars& l2
) const
{
    return modulus_*l2.cwiseInverse();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::Hookean::crossStiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    // -(E/l2^2) ((l1 - 1) + nu (l2 - 1)) + nu E/l2
    return
        modulus_
       *((ratio_ - (l1.array() - 1))/l2.array().square()).matrix();
}


Foam::capsule::secondPiolaStress Foam::capsule::elasticLaws::Hookean::stress
(
    const nodalScalars& I,
    const nodalScalars& J
) const
{
    // With s = l1 + l2 = (I + 2 J)^(1/2):
    //     W = E/2 [(s - 2)^2 - 2 (1 - nu) (J - s + 1)],
    //     alpha = E [1 - (1 + nu)/s], beta = E J [nu - (1 + nu)/s]
    const nodalScalars s = (I + 2*J).cwiseSqrt();
    const nodalScalars perSum = (modulus_*(1 + ratio_))*s.cwiseInverse();

    secondPiolaStress result(J.size());
    result.alpha = modulus_ - perSum.array();
    result.beta = J.array()*(modulus_*ratio_ - perSum.array());
    result.alphaJ = perSum.array()/s.array().square();
    result.alphaI = 0.5*result.alphaJ;
    result.betaI = 0.5*J.cwiseProduct(result.alphaJ);
    result.betaJ =
        modulus_*ratio_ - perSum.array() + J.array()*result.alphaJ.array();

    return result;
}
