/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "viscosityContrast.H"
#include "freeSpaceResponse.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::viscosityContrast::shearOf
(
    const nodalVectors& v
) const
{
    const closedSurface& surface = interface_.surface();
    const label m = surface.nRotations();
    nodalScalars moments(m);
    nodalMatrix ofShear(m, m);
    for (label k = 0; k < m; ++k)
    {
        moments(k) = surface.moment(v, k);
        for (label j = 0; j < m; ++j)
        {
            ofShear(k, j) =
                surface.moment(turned(surface.normal(), j), k);
        }
    }

    nodalVectors result(nodalVectors::Zero(v.rows(), v.cols()));
    if (m > 0)
    {
        const nodalScalars amounts = ofShear.inverse()*moments;
        for (label k = 0; k < m; ++k)
        {
            result += amounts(k)*turned(surface.normal(), k);
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::viscosityContrast::fluidJacobian
(
    const bool usesResponse
)
{
    const closedSurface& surface = interface_.surface();
    const surfaceBasis& basis = surface.basis();
    const label n = basis.nPacked();
    const label d = basis.nComponents();
    const scalar lambda = liquids_.ratio;
    nodalMatrix result = nodalMatrix::Identity(d*n, d*n);

    if (!liquids_.contrast())
    {
        return result;
    }
    traction_ = freeSpaceResponse::adjointDoubleLayer(surface);
    traction_.diagonal().array() += 0.5;
    if (!usesResponse)
    {
        return 0.5*(1 + lambda)*result;
    }
    result -= (1 - lambda)*traction_;
    if (!liquids_.scaling.inertial())
    {
        // W is 1
        return result;
    }

    // The normal traction is a pressure
    nodalMatrix normal = nodalMatrix::Zero(n, d*n);
    for (label i = 0; i < d; ++i)
    {
        normal += basis.multiplied
        (
            surface.normal().col(i), traction_.middleRows(i*n, n)
        );
    }
    normal *= (1 - lambda)*(1 - liquids_.scaling.pressureWeight());
    for (label i = 0; i < d; ++i)
    {
        result.middleRows(i*n, n) +=
            basis.multiplied(surface.normal().col(i), normal);
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::viscosityContrast::force
(
    const oneSidedFit::fitted& fluid,
    const nodalVectors& resolved,
    const nodalVectors& shortWaves,
    const nodalScalars& drivingPressure,
    const solvedVector& momentumRate,
    interfaceState& now
) const
{
    const closedSurface& surface = interface_.surface();
    const nodalVectors& n = surface.normal();
    const scalar mu = liquids_.viscosity;
    const scalar lambda = liquids_.ratio;
    const momentumScaling& scaling = liquids_.scaling;

    // The real pressure, scaled: see scaledFluid, driven flow
    nodalScalars pressure = fluid.pressure(mu) - drivingPressure;
    nodalVectors viscous = fluid.viscous(n, mu);
    nodalVectors vorticity = mu*fluid.vorticity(n);
    if (interface_.fitSide() > 0)
    {
        const nodalVectors along = surface.tangential(resolved);
        pressure -= dot(resolved, n);
        viscous += along;
        vorticity += along;
    }

    pressure -= dot(shortWaves, n);
    viscous += surface.tangential(shortWaves);

    // The resultant is known; pressure a.n with the constant a fills it
    const scalar s = scaling.scale();
    const nodalVectors traction = lambda*viscous - scaled(pressure/s, n);
    pressure += s*surface.pressureOf(surface.resultant(traction) - momentumRate);

    if (lambda > 1 && !scaling.inertial())
    {
        // So is the moment about the centroid, which the rate of momentum does
        // not change
        viscous -= shearOf(lambda*viscous - scaled(pressure/s, n))/lambda;
    }

    now.vorticity = vorticity;
    now.pressure = pressure/s;
    return
        (1 - lambda)
       *(viscous - scaling.pressureWeight()*scaled(pressure, n));
}


// ************************************************************************* //
