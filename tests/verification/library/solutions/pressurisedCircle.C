/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pressurisedCircle.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(pressurisedCircle, 0);
    addToRunTimeSelectionTable(analyticalSolution, pressurisedCircle, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::pressurisedCircle::pressurisedCircle
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    analyticalSolution(dict, directions, viscosity, density),
    pressure_
    (
        dict.get<scalar>("tension")
       *(directions.spatial() || directions.axisymmetric() ? 2 : 1)/radius_
    )
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::analyticalSolution::localFlow
Foam::capsule::analyticalSolutions::pressurisedCircle::relativeFlow
(
    const solvedVector& d,
    const scalar,
    const bool in
) const
{
    return {solvedVector::Zero(d.size()), in ? pressure_ : 0};
}
