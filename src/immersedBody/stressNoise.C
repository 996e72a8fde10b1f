/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "stressNoise.H"
#include "membrane.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::stressNoise::stressNoise()
:
    ofPoints_(0),
    noise_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::stressNoise::setPoints
(
    const membrane& body,
    const closedSurface& at,
    const scalar scale
)
{
    // A wave from point to point, along and across the membrane, small against
    // the distance of the points
    const surfaceBasis& basis = body.basis();
    const scalar height = 1e-4*at.meanRadius()*basis.spacing();
    nodalVectors x(at.nodes());
    x.colwise() += height*basis.shortestWave();
    x = basis.symmetric(x);
    const nodalVectors change =
        body.force(closedSurface(basis, x), at.areaElement())
      - body.force(at, at.areaElement());
    const scalar rms = change.norm()/Foam::sqrt(scalar(change.rows()));

    ofPoints_ = scale*SMALL*at.nodes().cwiseAbs().maxCoeff()/height*rms;
}


void Foam::capsule::stressNoise::setStresses(const scalar size)
{
    noise_ = 10*ofPoints_ + 100*SMALL*size;
}
