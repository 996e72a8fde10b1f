/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "systemFunction.H"
#include "membraneSystem.H"
#include "input.H"

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

const Foam::capsule::membraneSystem&
Foam::functionObjects::systemFunction::membranes() const
{
    return mesh_.lookupObject<capsule::membraneSystem>("membraneProperties");
}


void Foam::functionObjects::systemFunction::warnOfOthers
(
    const dictionary& dict,
    const wordList& own
)
{
    capsule::input::warnOfOthers
    (
        dict,
        capsule::input::joined(capsule::input::functionObjectEntries(), own)
    );
}


void Foam::functionObjects::systemFunction::writeHead
(
    OFstream& os,
    const string& title,
    const UList<const char*>& columns
) const
{
    os.precision(12);
    writeHeader(os, title);
    writeCommented(os, "Time");
    for (const char* column : columns)
    {
        writeTabbed(os, column);
    }
    os << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::systemFunction::systemFunction
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name)
{}


Foam::functionObjects::systemFunction::systemFunction
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const word& base
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, base, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::systemFunction::read(const dictionary& dict)
{
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::systemFunction::execute()
{
    return true;
}
