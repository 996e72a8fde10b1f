/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "elasticLaw.H"

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

Foam::autoPtr<Foam::capsule::elasticLaw> Foam::capsule::elasticLaw::New
(
    const dictionary& dict
)
{
    const word type(dict.get<word>("type"));

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

    return autoPtr<elasticLaw>(cstrIter()(dict));
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::capsule::elasticLaw::modulus
(
    const dictionary& dict,
    const word& entry
)
{
    const dimensionedScalar value(entry, dimForce/dimLength, dict);

    if (!(value.value() > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << value.value()
            << "; it must be positive [N/m]" << exit(FatalIOError);
    }
    return value.value();
}
