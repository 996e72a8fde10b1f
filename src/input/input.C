/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "input.H"
#include "dimensionedScalar.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace input
{

//- The first entry that names do not have, null if there is none
static const entry* other(const dictionary& dict, const wordList& names)
{
    for (const entry& e : dict)
    {
        bool found = false;
        for (const word& name : names)
        {
            found = found || e.keyword().match(name);
        }
        if (!found)
        {
            return &e;
        }
    }
    return nullptr;
}

//- Stop at a dictionary, or at dimensions that are given and wrong: there
//  newer releases abort, which cannot be caught
static void checkQuantity
(
    const dictionary& dict,
    const word& entry,
    const dimensionSet& dimensions
)
{
    if (dict.isDict(entry))
    {
        FatalIOErrorInFunction(dict)
            << "a value is wanted, not a dictionary" << exit(FatalIOError);
    }
    ITstream& is = dict.lookup(entry);
    const label first = (is.size() && is[0].isWord()) ? 1 : 0;
    if
    (
        is.size() > first && is[first].isPunctuation()
     && is[first].pToken() == token::BEGIN_SQR
    )
    {
        is.seek(first);
        const dimensionSet given(is);
        if (given != dimensions)
        {
            FatalIOErrorInFunction(dict)
                << "dimensions " << given << "; permitted: " << dimensions
                << exit(FatalIOError);
        }
    }
}

} // End namespace input
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::input::getPositive
(
    const dictionary& dict,
    const word& entry,
    const dimensionSet& dimensions,
    const char* unit
)
{
    const scalar value = guarded
    (
        dict,
        entry,
        [&]()
        {
            checkQuantity(dict, entry, dimensions);
            return dimensionedScalar(entry, dimensions, dict).value();
        }
    );
    if (!(value >= smallest && value <= largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << value
            << "; it must be positive, " << smallest << " to " << largest
            << " [" << unit << "]" << exit(FatalIOError);
    }
    return value;
}


const Foam::dictionary& Foam::capsule::input::subDict
(
    const dictionary& dict,
    const word& entry
)
{
    return guarded
    (
        dict,
        entry,
        [&]() -> const dictionary&
        {
            if (dict.found(entry) && !dict.isDict(entry))
            {
                FatalIOErrorInFunction(dict)
                    << "a dictionary is wanted" << exit(FatalIOError);
            }
            return dict.subDict(entry);
        }
    );
}


void Foam::capsule::input::permit
(
    const dictionary& dict,
    const wordList& permitted
)
{
    if (const entry* e = other(dict, permitted))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << e->keyword() << " is unknown; permitted: "
            << flatOutput(permitted) << exit(FatalIOError);
    }
}


void Foam::capsule::input::warnOfOthers
(
    const dictionary& dict,
    const wordList& used
)
{
    if (const entry* e = other(dict, used))
    {
        IOWarningInFunction(dict)
            << "Entry " << e->keyword() << " is not used; used: "
            << flatOutput(used) << nl << endl;
    }
}


Foam::wordList Foam::capsule::input::functionObjectEntries()
{
    return
    {
        "type", "libs", "functionObjectLibs", "region", "enabled", "log",
        "timeStart", "timeEnd", "startTime", "nStepsToStartTimeChange",
        "executeControl", "executeInterval", "writeControl", "writeInterval",
        "outputControl", "outputInterval", "controlMode", "triggerStart",
        "triggerEnd", "errors", "resetOnStartUp", "useNamePrefix",
        "writePrecision", "writeToFile", "useUserTime", "updateHeader",
        "writeFormat"
    };
}


Foam::wordList Foam::capsule::input::joined
(
    const wordList& a,
    const wordList& b
)
{
    wordList result(a);
    result.append(b);
    return result;
}
