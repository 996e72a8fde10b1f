/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "biconcave.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{
    defineTypeNameAndDebug(biconcave, 0);
    addToRunTimeSelectionTable(curveShape, biconcave, plane);
    addToRunTimeSelectionTable(curveShape, biconcave, wedge);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::biconcave::biconcave
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    curveShape(dict, directions, {"radius"}),
    radius_(length(dict, "radius"))
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::vector2 Foam::capsule::shapes::biconcave::local
(
    const scalar chi
) const
{
    return section(radius_, chi);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::vector2 Foam::capsule::shapes::biconcave::section
(
    const scalar radius,
    const scalar chi
)
{
    const scalar alpha = 1.38581894;
    const scalar s2 = sqr(std::sin(chi));

    return radius*alpha*vector2
    (
        0.5*(0.207 + 2.003*s2 - 1.123*sqr(s2))*std::cos(chi),
        std::sin(chi)
    );
}
