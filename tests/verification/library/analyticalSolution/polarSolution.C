/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "polarSolution.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::polarSolution::polarSolution
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    analyticalSolution(dict, directions, viscosity, density)
{
    if (directions.spatial())
    {
        FatalIOErrorInFunction(dict)
            << "Entry type: " << dict.get<word>("type") << " is a solution in"
            << " the plane or a wedge, not in space" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::capsule::polarSolution::radius
(
    const scalar,
    const scalar
) const
{
    return radius_;
}


Foam::capsule::vector2 Foam::capsule::polarSolution::polarForce
(
    const scalar,
    const scalar
) const
{
    return vector2::Zero();
}


bool Foam::capsule::polarSolution::encloses
(
    const solvedVector& d,
    const scalar t
) const
{
    return d.norm() < radius(std::atan2(d(1), d(0)), t);
}


Foam::capsule::analyticalSolution::localFlow
Foam::capsule::polarSolution::relativeFlow
(
    const solvedVector& d,
    const scalar t,
    const bool in
) const
{
    const scalar theta = std::atan2(d(1), d(0));
    const polarFlow u = flow(d.norm(), theta, t, in);
    const scalar c = std::cos(theta);
    const scalar s = std::sin(theta);
    return {vector2(u.r*c - u.theta*s, u.r*s + u.theta*c), u.p};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::polarSolution::force
(
    const closedSurface& surface,
    const scalar t
) const
{
    nodalVectors result(surface.size(), 2);
    for (label i = 0; i < surface.size(); ++i)
    {
        const solvedVector d = relative(surface.nodes().row(i), t);
        const vector2 f = polarForce(std::atan2(d(1), d(0)), t);
        result.row(i) =
            f(0)*surface.normal().row(i) + f(1)*surface.tangent().row(i);
    }
    return result;
}
