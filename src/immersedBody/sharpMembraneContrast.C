/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sharpMembrane.H"
#include "freeSpaceResponse.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::sharpMembrane::fluidDerivative
(
    const couplingMethod& method
)
{
    const label n = basis().nPacked();
    const label d = basis().nComponents();
    nodalMatrix derivative = nodalMatrix::Identity(d*n, d*n);

    if (ratio_ != 1)
    {
        traction_ = freeSpaceResponse::adjointDoubleLayer(surface());
        traction_.diagonal().array() += 0.5;
        if (!method.usesResponse())
        {
            return 0.5*(1 + ratio_)*derivative;
        }
        derivative -= (1 - ratio_)*traction_;

        // The normal traction is a pressure
        nodalMatrix normal = nodalMatrix::Zero(n, d*n);
        for (label i = 0; i < d; ++i)
        {
            normal += basis().multiplied
            (
                surface().normal().col(i), traction_.middleRows(i*n, n)
            );
        }
        normal *= (1 - ratio_)*(1 - scaling_.pressureWeight());
        for (label i = 0; i < d; ++i)
        {
            derivative.middleRows(i*n, n) +=
                basis().multiplied(surface().normal().col(i), normal);
        }
    }
    return derivative;
}


Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::shearOf
(
    const nodalVectors& v
) const
{
    const label m = surface().nRotations();
    nodalScalars moments(m);
    nodalMatrix ofShear(m, m);
    for (label k = 0; k < m; ++k)
    {
        moments(k) = surface().moment(v, k);
        for (label j = 0; j < m; ++j)
        {
            ofShear(k, j) =
                surface().moment(turned(surface().normal(), j), k);
        }
    }

    nodalVectors result(nodalVectors::Zero(v.rows(), v.cols()));
    if (m > 0)
    {
        const nodalScalars amounts = ofShear.inverse()*moments;
        for (label k = 0; k < m; ++k)
        {
            result += amounts(k)*turned(surface().normal(), k);
        }
    }
    return result;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::contrastTraction
(
    const solvedVector& driving
)
{
    if (ratio_ == 1)
    {
        return immersedMembrane::contrastTraction(driving);
    }

    const nodalVectors& n = surface().normal();

    // The real pressure, scaled: see membraneSystem, driven flow
    nodalScalars pressure =
        fluid_.pressure(mu_)
      - (surface().nodes().rowwise() - pressureOrigin())*driving.transpose();
    nodalVectors viscous = fluid_.viscous(n, mu_);
    nodalVectors vorticity = mu_*fluid_.vorticity(n);
    if (interface_.fitSide() > 0)
    {
        const nodalVectors f = resolvedForce();
        const nodalVectors along = surface().tangential(f);
        pressure -= dot(f, n);
        viscous += along;
        vorticity += along;
    }

    const nodalVectors shortWaves = basis().unpack(traction_*unresolvedForce());
    pressure -= dot(shortWaves, n);
    viscous += surface().tangential(shortWaves);

    // The resultant is known; pressure a.n with the constant a fills it
    const scalar s = scaling_.scale();
    const nodalVectors traction = ratio_*viscous - scaled(pressure/s, n);
    pressure +=
        s*surface().pressureOf(surface().resultant(traction) - momentumRate());

    if (ratio_ > 1 && !scaling_.inertial())
    {
        // So is the moment about the centroid, which the rate of momentum does
        // not change
        viscous -= shearOf(ratio_*viscous - scaled(pressure/s, n))/ratio_;
    }

    membrane_.now().vorticity = vorticity;
    membrane_.now().pressure = pressure/s;
    return (1 - ratio_)*(viscous - scaling_.pressureWeight()*scaled(pressure, n));
}


// ************************************************************************* //
