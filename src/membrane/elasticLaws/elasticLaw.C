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
    const word type(input::get<word>(dict, "type"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "elastic law",
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }

    return autoPtr<elasticLaw>(cstrIter()(dict, plane));
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
