/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "circle.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{
    defineTypeNameAndDebug(circle, 0);
    addToRunTimeSelectionTable(curveShape, circle, plane);
    addToRunTimeSelectionTable(curveShape, circle, wedge);
    addNamedToRunTimeSelectionTable(curveShape, circle, wedge, sphere);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::circle::circle
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    curveShape(dict, directions, {"radius"}),
    radius_(length(dict, "radius"))
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::vector2 Foam::capsule::shapes::circle::local
(
    const scalar chi
) const
{
    return radius_*vector2(std::cos(chi), std::sin(chi));
}
