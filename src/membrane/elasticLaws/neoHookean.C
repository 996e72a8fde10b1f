/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "neoHookean.H"
#include "familyEntries.H"
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
    static const familyEntries<elasticLaw> entries({"shearModulus", "form"});
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::elasticLaws::neoHookean::incompressible
(
    const dictionary& dict,
    const bool plane
)
{
    const word entry("form");
    const bool found = dict.found(entry);
    const word form(found ? input::get<word>(dict, entry) : word());

    if (found ? form != "publication" && form != "incompressible" : !plane)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << (found ? form : word("missing"))
            << "; permitted"
            << (plane ? "" : ", without a default")
            << ": publication, T_i = E_s (l_i^2 - 1), or incompressible,"
            << " T1 = G (l1/l2 - (l1 l2)^-3)"
            << exit(FatalIOError);
    }
    if (!found)
    {
        Info<< "Elastic law neoHookean: form publication, T = E_s (s^2 - 1)"
            << endl;
    }
    return form == "incompressible";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::neoHookean::neoHookean
(
    const dictionary& dict,
    const bool plane
)
:
    elasticLaw(dict),
    shearModulus_(modulus(dict, "shearModulus")),
    plane_(plane),
    incompressible_(incompressible(dict, plane))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::neoHookean::tension
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    if (!incompressible_)
    {
        return shearModulus_*(l1.array().square() - 1).matrix();
    }
    const auto product = l1.array()*l2.array();

    return
        shearModulus_
       *(l1.array()/l2.array() - product.cube().inverse()).matrix();
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::neoHookean::energy
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    if (incompressible_)
    {
        const auto product = l1.array()*l2.array();

        return
            0.5*shearModulus_
           *(
                l1.array().square() + l2.array().square()
              + product.square().inverse() - 3
            ).matrix();
    }
    if (!plane_)
    {
        FatalErrorInFunction
            << "The form publication has no energy where both stretches vary"
            << abort(FatalError);
    }
    return
        shearModulus_
       *(l1.array().cube()/3 - l1.array() + scalar(2)/3);
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::neoHookean::stiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    if (!incompressible_)
    {
        return 2*shearModulus_*l1;
    }
    const auto product = l1.array()*l2.array();

    return
        shearModulus_
       *(
            l2.array().inverse() + 3*(product.cube()*l1.array()).inverse()
        ).matrix();
}


Foam::capsule::nodalScalars
Foam::capsule::elasticLaws::neoHookean::crossStiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    if (!incompressible_)
    {
        return nodalScalars::Zero(l1.size());
    }
    const auto product = l1.array()*l2.array();

    return
        shearModulus_
       *(
            3*(product.cube()*l2.array()).inverse()
          - l1.array()/l2.array().square()
        ).matrix();
}


Foam::capsule::secondPiolaStress Foam::capsule::elasticLaws::neoHookean::stress
(
    const nodalScalars&,
    const nodalScalars& J
) const
{
    // alpha = G, beta = -G/J^2; the publication's T_i are those of
    // alpha = -beta = E_s J
    secondPiolaStress result(J.size());
    if (incompressible_)
    {
        result.alpha.setConstant(shearModulus_);
        result.beta = -shearModulus_*J.array().square().inverse();
        result.betaJ = 2*shearModulus_*J.array().cube().inverse();
    }
    else
    {
        result.alpha = shearModulus_*J;
        result.beta = -result.alpha;
        result.alphaJ.setConstant(shearModulus_);
        result.betaJ.setConstant(-shearModulus_);
    }
    return result;
}
