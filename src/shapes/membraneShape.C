/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "curveShape.H"
#include "spatialShape.H"
#include "dimensionSets.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(membraneShape, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneShape::membraneShape
(
    const dictionary& dict,
    const solvedDirections& directions,
    const wordList& others
)
:
    centre_(directions(input::get<point>(dict, "centre"))),
    initialStretch_
    (
        input::getBetweenOrDefault<scalar>(dict, "initialStretch", 1, 0.2, 5)
    )
{
    input::permit
    (
        dict,
        input::joined({"type", "centre", "initialStretch"}, others)
    );
}


Foam::autoPtr<Foam::capsule::membraneShape> Foam::capsule::membraneShape::New
(
    const dictionary& dict,
    const solvedDirections& directions
)
{
    return
        directions.spatial()
      ? autoPtr<membraneShape>(spatialShape::New(dict, directions))
      : autoPtr<membraneShape>(curveShape::New(dict, directions));
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::capsule::membraneShape::length
(
    const dictionary& dict,
    const word& entry
)
{
    return input::getPositive(dict, entry, dimLength, "m");
}


Foam::fileName Foam::capsule::membraneShape::fileEntry(const dictionary& dict)
{
    const string name(input::get<string>(dict, "file").expand());
    if (!string::valid<fileName>(name))
    {
        FatalIOErrorInFunction(dict)
            << "Entry file is " << name << "; it must be the name of a file"
            << exit(FatalIOError);
    }
    return fileName(name);
}
