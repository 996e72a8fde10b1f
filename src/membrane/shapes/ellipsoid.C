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
    addToRunTimeSelectionTable(membraneShape, ellipsoid, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::ellipsoid::ellipsoid
(
    const dictionary& dict,
    const solvedDirections& plane
)
:
    ellipse(dict, plane)
{
    needWedge(dict, plane, "biconcave, circle, ellipse, points");
}
