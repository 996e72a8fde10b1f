/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "levelSetWriter.H"
#include "input.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::capsule::levelSetWriter::extent>
Foam::capsule::levelSetWriter::extentNames_
({
    { extent::none, "none" },
    { extent::near, "near" },
    { extent::whole, "whole" },
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::levelSetWriter::levelSetWriter(const dictionary& dict)
:
    extent_(extent::near)
{
    if (dict.found("levelSet"))
    {
        const word written(input::get<word>(dict, "levelSet"));
        if (!extentNames_.found(written))
        {
            FatalIOErrorInFunction(dict)
                << "Entry levelSet is " << written << "; permitted: "
                << flatOutput(extentNames_.toc()) << exit(FatalIOError);
        }
        extent_ = extentNames_[written];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::levelSetWriter::write
(
    const membraneLevelSet& levelSet
) const
{
    if (extent_ == extent::near)
    {
        levelSet.near()().write();
    }
    else if (extent_ == extent::whole)
    {
        levelSet.whole()().write();
    }
}
