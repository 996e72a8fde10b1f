/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "couplingMethod.H"
#include "familyEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(couplingMethod, 0);
    defineRunTimeSelectionTable(couplingMethod, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::couplingMethod::couplingMethod(const dictionary& dict)
:
    conserveArea_(input::getOrDefault<bool>(dict, "conserveArea", true))
{
    familyEntries<couplingMethod>::permit
    (
        dict,
        {
            "type",
            "interface",
            "stressTolerance",
            "displacementTolerance",
            "maxIter",
            "conserveArea",
            "failedStep",
            "maxCuts"
        }
    );
}


Foam::autoPtr<Foam::capsule::couplingMethod>
Foam::capsule::couplingMethod::New(const dictionary& dict)
{
    const auto& table = *dictionaryConstructorTablePtr_;
    const word type(input::choice(dict, "type", table.sortedToc()));

    return autoPtr<couplingMethod>(table[type](dict));
}
