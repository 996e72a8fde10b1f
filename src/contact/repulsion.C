/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "repulsion.H"
#include "input.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::repulsion::linear_ = 0.125;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::repulsion::repulsion(const dictionary& dict)
:
    range_(input::getPositive(dict, "range", dimLength, "m")),
    strength_(input::getPositive(dict, "strength", dimPressure, "Pa"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::repulsion::energy(const scalar gap) const
{
    if (gap >= range_)
    {
        return 0;
    }
    const scalar g = max(gap, linear_*range_);
    const scalar beyond = g - gap;

    return
        strength_*(sqr(range_)/g - g - 2*range_*std::log(range_/g))
      + beyond*(pressure(g) + 0.5*beyond*stiffness(g));
}


Foam::scalar Foam::capsule::repulsion::pressure(const scalar gap) const
{
    if (gap >= range_)
    {
        return 0;
    }
    const scalar g = max(gap, linear_*range_);

    return strength_*sqr(range_/g - 1) + (g - gap)*stiffness(g);
}


Foam::scalar Foam::capsule::repulsion::stiffness(const scalar gap) const
{
    if (gap >= range_)
    {
        return 0;
    }
    const scalar g = max(gap, linear_*range_);

    return 2*strength_*(range_/g - 1)*range_/sqr(g);
}


// ************************************************************************* //
