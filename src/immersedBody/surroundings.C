/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surroundings.H"
#include "immersedBody.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surroundings::surroundings
(
    const scalar density,
    const scalar viscosity
)
:
    density_(density),
    viscosity_(viscosity),
    outer_(nullptr),
    rho_(density),
    mu_(viscosity)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::surroundings::setStep()
{
    rho_ = density_*scale();
    mu_ = viscosity_*viscousScale();
}


Foam::scalar Foam::capsule::surroundings::scale() const
{
    return outer_ ? outer_->scale() : 1;
}


Foam::scalar Foam::capsule::surroundings::viscousScale() const
{
    return outer_ ? outer_->viscousScale() : 1;
}


Foam::scalar Foam::capsule::surroundings::viscosityRatio() const
{
    return outer_ ? outer_->viscosityRatio() : 1;
}


Foam::scalar Foam::capsule::surroundings::viscosity() const
{
    return outer_ ? viscosity_*outer_->viscosityRatio() : viscosity_;
}
