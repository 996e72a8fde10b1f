/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphereMode.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(sphereMode, 0);
    addToRunTimeSelectionTable(analyticalSolution, sphereMode, dictionary);
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::vector2
Foam::capsule::analyticalSolutions::sphereMode::harmonic
(
    const scalar theta
) const
{
    // k P_k = (2k - 1) cos P_k-1 - (k - 1) P_k-2, and its derivative
    const scalar c = std::cos(theta);
    const scalar s = std::sin(theta);
    vector2 before(0, 0);
    vector2 now(1, 0);
    for (label k = 1; k <= l_; ++k)
    {
        const vector2 next
        (
            (2*k - 1)*c*now(0) - (k - 1)*before(0),
            (2*k - 1)*(c*now(1) - s*now(0)) - (k - 1)*before(1)
        );
        before = now;
        now = next/k;
    }
    return now;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::sphereMode::sphereMode
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    polarSolution(dict, directions, viscosity, density),
    l_(dict.getCheck<label>("mode", labelMinMax::ge(0))),
    flow_
    (
        l_,
        radius_,
        viscosity,
        {dict.get<scalar>("normal"), dict.get<scalar>("tangential"), 0}
    )
{
    const vector centre(dict.get<vector>("centre"));
    if
    (
        !directions.axisymmetric()
     || mag(directions.radius(directions(centre))) > 1e-9*radius_
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entry type: " << typeName << " needs a wedge with the entry"
            << " centre on its axis, not " << centre << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::polarSolution::polarFlow
Foam::capsule::analyticalSolutions::sphereMode::flow
(
    const scalar r,
    const scalar theta,
    const scalar,
    const bool in
) const
{
    const vector2 Y = harmonic(theta);
    const sphereFlow::factors at = flow_(r, in);
    return {at.U*Y(0), at.V*Y(1), at.p*Y(0)};
}


Foam::capsule::vector2
Foam::capsule::analyticalSolutions::sphereMode::polarForce
(
    const scalar theta,
    const scalar
) const
{
    const vector2 Y = harmonic(theta);
    return vector2(flow_.force().normal*Y(0), flow_.force().tangential*Y(1));
}
