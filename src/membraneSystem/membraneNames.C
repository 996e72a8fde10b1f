/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneNames.H"
#include "input.H"
#include "releases.H"
#include "IFstream.H"
#include "HashSet.H"
#include <cctype>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace membraneNames
{

//- Can a name be that of a file and a word of a dictionary, in any program?
static bool isName(const std::string& name)
{
    for (const unsigned char c : name)
    {
        if (c > 127 || !(std::isalnum(c) || c == '_' || c == '-' || c == '.'))
        {
            return false;
        }
    }
    return !name.empty() && (std::isalnum(name[0]) || name[0] == '_');
}


//- The first dictionary in another one of the top level whose name in the text
//  of a file is no name, or is there twice: OpenFOAM makes nested dictionaries
//  of a/b, and one of two of the same name; empty if there is none
static string wrongName(const fileName& path, const word& in)
{
    IFstream is(path);
    HashSet<string> names;
    string name;
    string top;
    label depth = 0;
    token t;
    while (is.read(t).good() && t.good())
    {
        if (t == token::BEGIN_BLOCK)
        {
            if (depth == 0)
            {
                top = name;
            }
            else if
            (
                depth == 1 && top == in
             && (!isName(name) || !names.insert(name))
            )
            {
                return name;
            }
            ++depth;
        }
        else if (t == token::END_BLOCK)
        {
            --depth;
        }
        else if (t.isWord())
        {
            name = t.wordToken();
        }
        else if (t.isString())
        {
            name = t.stringToken();
        }
        else if (t == token::DIVIDE)
        {
            name += '/';
        }
    }
    return string::null;
}

} // End namespace membraneNames
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::capsule::membraneNames::check(const IOdictionary& properties)
{
    HashSet<word> names;
    for (const word& in : wordList({"membranes", "bodies"}))
    {
        if (in == "bodies" && !properties.found(in))
        {
            continue;
        }
        const dictionary& dict = input::subDict(properties, in);
        const auto refuse = [&](const std::string& name)
        {
            FatalIOErrorInFunction(dict)
                << (in == "bodies" ? "Body " : "Membrane ") << name.c_str()
                << ": the name of a membrane or a body is that of files and of"
                << " dictionary entries, each once; permitted: letters,"
                << " digits, _, - and ., with a letter, a digit or _ first, and"
                << " no two the same" << exit(FatalIOError);
        };
        for (const entry& e : dict)
        {
            if
            (
                e.keyword().isPattern() || !isName(e.keyword())
             || !names.insert(e.keyword())
            )
            {
                refuse(e.keyword());
            }
        }

        string name;
        if (Pstream::master())
        {
            name = wrongName(properties.filePath(), in);
        }
        broadcast(name);
        if (!name.empty())
        {
            refuse(name);
        }
    }
}


// ************************************************************************* //
