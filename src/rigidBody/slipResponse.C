/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "slipResponse.H"
#include "freeSpaceResponse.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::slipResponse::normalPart
(
    const closedSurface& surface
)
{
    const surfaceBasis& basis = surface.basis();
    const label n = basis.nPacked();
    const label d = basis.nComponents();
    const nodalMatrix identity(nodalMatrix::Identity(n, n));
    nodalMatrix result(d*n, d*n);
    for (label i = 0; i < d; ++i)
    {
        for (label j = 0; j < d; ++j)
        {
            result.block(i*n, j*n, n, n) = basis.multiplied
            (
                surface.normal().col(i),
                basis.multiplied(surface.normal().col(j), identity)
            );
        }
    }
    return result;
}


void Foam::capsule::slipResponse::addInertia
(
    const closedSurface& surface,
    const scalar mu,
    const scalar l2,
    const nodalScalars& normal,
    const nodalScalars& flux
)
{
    const nodalMatrix S2 = 2*mu*velocity_;
    const nodalMatrix one(nodalMatrix::Identity(S2.rows(), S2.cols()));
    const nodalMatrix N = normalPart(surface);
    inertia_ =
        mu*l2
       *((one + Foam::sqrt(l2)*S2).partialPivLu().solve(S2) + 2*N*S2*N);

    // The pressure inside lets no net flux pass
    const nodalMatrix all = (force_ + 2*inertia_).inverse();
    const nodalScalars ofPressure = all*normal;
    velocity_ =
        all - ofPressure*(flux.transpose()*all)/flux.dot(ofPressure);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::slipResponse::slipResponse
(
    const closedSurface& surface,
    const scalar mu,
    const scalar inertia
)
:
    velocity_(freeSpaceResponse::singleLayer(surface, mu))
{
    const surfaceBasis& basis = surface.basis();
    const nodalScalars area =
        basis.weights().cwiseProduct(surface.areaElement());
    const nodalScalars normal = basis.pack(surface.normal());
    const nodalScalars flux =
        basis.packedWeights(scaled(area, surface.normal()))/surface.area();

    // A uniform pressure makes as much flux as one of a wave of the size of
    // the body would
    const nodalMatrix pressure =
        surface.meanRadius()/mu*normal*flux.transpose();
    force_ = (velocity_ + pressure).inverse();
    if (inertia > 0)
    {
        addInertia(surface, mu, inertia/mu, normal, flux);
        force_ = (velocity_ + pressure).inverse();
    }
    force_ -= (force_*normal)*flux.transpose();
}


// ************************************************************************* //
