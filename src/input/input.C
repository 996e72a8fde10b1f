/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "input.H"
#include <cmath>

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

} // End namespace input
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::ITstream& Foam::capsule::input::tokens
(
    const dictionary& dict,
    const word& entry
)
{
    const bool missing = !dict.found(entry);
    if (missing || dict.isDict(entry))
    {
        FatalIOErrorInFunction(dict)
            << (missing ? "missing" : "a value is wanted, not a dictionary")
            << exit(FatalIOError);
    }
    return dict.lookup(entry);
}


void Foam::capsule::input::checkDimensions
(
    const dictionary& dict,
    const word& entry,
    const dimensionSet& dimensions
)
{
    ITstream& is = tokens(dict, entry);
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
                << "dimensions " << given << ", not " << dimensions
                << exit(FatalIOError);
        }
    }
}


template<>
Foam::label Foam::capsule::input::get<Foam::label>
(
    const dictionary& dict,
    const word& entry,
    const string& permitted
)
{
    const string whole
    (
        permitted.empty() ? string("whole numbers") : "whole, " + permitted
    );
    const scalar value = get<scalar>(dict, entry, whole);
    // What is below the range of a scalar is read as 0, no whole number
    const bool vanished = value == 0 && !tokens(dict, entry)[0].isLabel();
    if (vanished || !(mag(value) < labelMax && value == std::round(value)))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << value << "; permitted: "
            << whole.c_str() << exit(FatalIOError);
    }
    return label(value);
}


Foam::scalar Foam::capsule::input::getPositive
(
    const dictionary& dict,
    const word& entry,
    const dimensionSet& dimensions,
    const char* unit
)
{
    const string permitted
    (
        "positive, " + between(smallest, largest) + " [" + unit + "]"
    );
    const scalar value =
        getQuantity<scalar>(dict, entry, dimensions, permitted);
    if (!(value >= smallest && value <= largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << value << "; permitted: "
            << permitted.c_str() << exit(FatalIOError);
    }
    return value;
}


Foam::word Foam::capsule::input::choice
(
    const dictionary& dict,
    const word& entry,
    const wordList& permitted,
    const char* where
)
{
    string list;
    for (const word& name : permitted)
    {
        list += (list.empty() ? "" : ", ") + name;
    }
    list += where;
    const word chosen(get<word>(dict, entry, list));
    if (!permitted.found(chosen))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << chosen << "; permitted: "
            << list.c_str() << exit(FatalIOError);
    }
    return chosen;
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
            if (!dict.isDict(entry))
            {
                FatalIOErrorInFunction(dict)
                    << (dict.found(entry) ? "" : "missing; ")
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
