/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphere.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{
    defineTypeNameAndDebug(sphere, 0);
    addToRunTimeSelectionTable(membraneShape, sphere, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::sphere::sphere
(
    const dictionary& dict,
    const solvedDirections& plane
)
:
    circle(dict, plane)
{
    needWedge(dict, plane, "biconcave, circle, ellipse, points");
}
