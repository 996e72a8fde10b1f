/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "elasticLaw.H"
#include "familyEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(elasticLaw, 0);
    defineRunTimeSelectionTable(elasticLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaw::elasticLaw(const dictionary& dict)
{
    familyEntries<elasticLaw>::permit(dict, {"type"});
}


Foam::autoPtr<Foam::capsule::elasticLaw> Foam::capsule::elasticLaw::New
(
    const dictionary& dict,
    const bool plane
)
{
    const auto& table = *dictionaryConstructorTablePtr_;
    const word type(input::choice(dict, "type", table.sortedToc()));

    return autoPtr<elasticLaw>(table[type](dict, plane));
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::capsule::elasticLaw::modulus
(
    const dictionary& dict,
    const word& entry
)
{
    return input::getPositive(dict, entry, dimForce/dimLength, "N/m");
}
