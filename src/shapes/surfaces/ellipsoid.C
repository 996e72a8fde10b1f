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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{

//- The entry semiAxes, which must be three lengths
static vector readSemiAxes(const dictionary& dict)
{
    const scalarList a(input::get<scalarList>(dict, "semiAxes"));
    bool good = (a.size() == 3);
    for (const scalar length : a)
    {
        good = good && length >= input::smallest && length <= input::largest;
    }
    if (!good)
    {
        FatalIOErrorInFunction(dict)
            << "Entry semiAxes is " << flatOutput(a)
            << "; permitted: three lengths, all three must be positive, "
            << input::smallest << " to " << input::largest << " [m]"
            << exit(FatalIOError);
    }
    return vector(a[0], a[1], a[2]);
}

} // End namespace shapes
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::ellipsoid::ellipsoid
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    spatialShape(dict, directions, {"semiAxes"}),
    semiAxes_(readSemiAxes(dict))
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::point Foam::capsule::shapes::ellipsoid::local(const vector& y) const
{
    return cmptMultiply(semiAxes_, y);
}
