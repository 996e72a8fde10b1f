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
    addToRunTimeSelectionTable(spatialShape, sphere, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::sphere::sphere
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    spatialShape(dict, directions, {"radius"}),
    radius_(length(dict, "radius"))
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::point Foam::capsule::shapes::sphere::local(const vector& y) const
{
    return radius_*y;
}
