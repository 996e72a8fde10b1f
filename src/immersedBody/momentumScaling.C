/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.


\*---------------------------------------------------------------------------*/

#include "momentumScaling.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::momentumScaling::momentumScaling(const scalar ratio)
:
    momentumScaling(ratio, GREAT)
{}


Foam::capsule::momentumScaling::momentumScaling
(
    const scalar ratio,
    const scalar viscousNumber
)
:
    ratio_(ratio),
    viscousNumber_(min(ratio, scalar(1))*viscousNumber),
    scale_(1/ratio),
    viscousScale_(1)
{
    const scalar inertia = 1/viscousNumber;
    const scalar scale = (inertia + 4)/(inertia + 4*ratio);
    if (ratio != 1 && mag(scale*ratio - 1) >= 0.01)
    {
        scale_ = scale;
        viscousScale_ = scale*ratio;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::momentumScaling::pressureWeight() const
{
    return (1/scale_ - 1)/(ratio_ - 1);
}


Foam::scalar Foam::capsule::momentumScaling::relaxation() const
{
    return 1/(1 + 0.1/viscousNumber_);
}


Foam::scalar Foam::capsule::momentumScaling::feedback() const
{
    return 0.15/viscousNumber_;
}


// ************************************************************************* //
