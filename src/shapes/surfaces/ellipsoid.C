/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "ellipsoid.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{
    defineTypeNameAndDebug(ellipsoid, 0);
    addToRunTimeSelectionTable(spatialShape, ellipsoid, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::ellipsoid::ellipsoid
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    spatialShape(dict, directions, {"semiAxes"}),
    semiAxes_(input::get<vector>(dict, "semiAxes"))
{
    for (direction d = 0; d < 3; ++d)
    {
        if
        (
            !(semiAxes_[d] >= input::smallest && semiAxes_[d] <= input::largest)
        )
        {
            FatalIOErrorInFunction(dict)
                << "Entry semiAxes is " << semiAxes_
                << "; all three must be positive, " << input::smallest
                << " to " << input::largest << " [m]" << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::point Foam::capsule::shapes::ellipsoid::local(const vector& y) const
{
    return cmptMultiply(semiAxes_, y);
}
