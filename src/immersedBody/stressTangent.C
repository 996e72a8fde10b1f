/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "stressTangent.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::stressTangent::setFluid
(
    const nodalMatrix& mobility,
    const nodalMatrix& fluidJacobian
)
{
    mobility_ = mobility;
    fluidJacobian_ = fluidJacobian;
}


void Foam::capsule::stressTangent::setDisplacements
(
    const nodalMatrix& displacements
)
{
    displacements_ = displacements;
}


void Foam::capsule::stressTangent::linearise()
{
    derivative_.compute(fluidJacobian_);
}


void Foam::capsule::stressTangent::linearise(const nodalMatrix& forceJacobian)
{
    forceJacobian_ = forceJacobian;
    derivative_.compute(fluidJacobian_ - forceJacobian_*displacements_);
}
