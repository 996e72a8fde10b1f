/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "drivingForce.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(drivingForce, 0);
    defineRunTimeSelectionTable(drivingForce, dictionary);
    addToRunTimeSelectionTable(drivingForce, drivingForce, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::vector Foam::capsule::drivingForce::readAlongPeriods
(
    const dictionary& dict,
    const word& entry,
    const dimensionSet& dimensions,
    const solvedDirections& directions
)
{
    input::permit(dict, {"type", entry});

    const vector value = input::getQuantity<vector>
    (
        dict, entry, dimensions, "a vector along a period of the mesh"
    );
    if (!(mag(value) <= input::largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << value << "; its magnitude may be"
            << " up to " << input::largest << exit(FatalIOError);
    }

    vector beside(value);
    List<vector> periods;
    for (const solvedVector& p : directions.images().periods())
    {
        periods.append(directions.toVector(p));
        beside -= (value & periods.last())/magSqr(periods.last())*periods.last();
    }
    if (periods.empty() || mag(beside) > 1e-9*mag(value))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << value << "; it must lie along a"
            << " period of the mesh, the translation of cyclic patches: the"
            << " mesh has the periods " << flatOutput(periods)
            << exit(FatalIOError);
    }
    return value;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::drivingForce::drivingForce
(
    const dictionary& dict,
    const fvMesh&
)
{
    input::permit(dict, {"type"});
}
