/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "biconcaveDisc.H"
#include "biconcave.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{
    defineTypeNameAndDebug(biconcaveDisc, 0);
    addToRunTimeSelectionTable(spatialShape, biconcaveDisc, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::biconcaveDisc::biconcaveDisc
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    spatialShape(dict, directions, {"radius"}),
    radius_(length(dict, "radius"))
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::point Foam::capsule::shapes::biconcaveDisc::local(const vector& y) const
{
    const scalar across = std::hypot(y.x(), y.y());
    const vector2 section =
        biconcave::section(radius_, std::atan2(across, y.z()));

    // The distance from the axis over that of the unit sphere; no node of a
    // grid is on the axis, where it has a limit
    const scalar stretch = section(1)/max(across, VSMALL);
    return point(stretch*y.x(), stretch*y.y(), section(0));
}
