/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "ellipse.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{
    defineTypeNameAndDebug(ellipse, 0);
    addToRunTimeSelectionTable(curveShape, ellipse, plane);
    addToRunTimeSelectionTable(curveShape, ellipse, wedge);
    addNamedToRunTimeSelectionTable(curveShape, ellipse, wedge, ellipsoid);
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

//- The entry semiAxes, which must be two lengths
static Pair<scalar> readSemiAxes(const dictionary& dict)
{
    const scalarList a(input::get<scalarList>(dict, "semiAxes"));
    bool good = (a.size() == 2);
    for (const scalar length : a)
    {
        good = good && length >= input::smallest && length <= input::largest;
    }
    if (!good)
    {
        FatalIOErrorInFunction(dict)
            << "Entry semiAxes is " << flatOutput(a)
            << "; permitted: two lengths, both must be positive, "
            << input::smallest << " to " << input::largest << " [m]"
            << exit(FatalIOError);
    }
    return Pair<scalar>(a[0], a[1]);
}

} // End namespace shapes
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::ellipse::ellipse
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    curveShape(dict, directions, {"semiAxes"}),
    semiAxes_(readSemiAxes(dict))
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::vector2 Foam::capsule::shapes::ellipse::local
(
    const scalar chi
) const
{
    return vector2
    (
        semiAxes_.first()*std::cos(chi),
        semiAxes_.second()*std::sin(chi)
    );
}
