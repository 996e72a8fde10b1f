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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::ellipse::ellipse
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    curveShape(dict, directions, {"semiAxes"}),
    semiAxes_(input::get<Pair<scalar>>(dict, "semiAxes"))
{
    for (const scalar length : semiAxes_)
    {
        if (!(length >= input::smallest && length <= input::largest))
        {
            FatalIOErrorInFunction(dict)
                << "Entry semiAxes is " << semiAxes_
                << "; both must be positive, " << input::smallest << " to "
                << input::largest << " [m]" << exit(FatalIOError);
        }
    }
}


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
