/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneMotion.H"
#include "sphericalBasis.H"

const Foam::scalar Foam::capsule::membraneMotion::waves = 3;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::membraneMotion::volumeDerivative
(
    const closedSurface& surface
)
{
    return
        surface.basis().packedWeights(surface.volumeDerivative()).transpose();
}


Foam::capsule::nodalScalars Foam::capsule::membraneMotion::shift
(
    const closedSurface& surface
)
{
    return surface.basis().pack(surface.normal())/surface.area();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneMotion::membraneMotion
(
    const membrane& body,
    const closedSurface& interface,
    const closedSurface& predicted,
    const nodalFilter& filter,
    const timeScheme& scheme,
    const bool conserveVolume
)
:
    body_(body),
    interface_(interface),
    scheme_(scheme),
    conserveVolume_(conserveVolume),
    filter_(filter),
    excess_(excess(body, predicted, body.old(0).velocity, 0.25*scheme.c))
{
    reduced_[0] = body.basis().reduced(filter, 0);
    reduced_[1] =
        body.basis().axisymmetric()
      ? body.basis().reduced(filter, 1)
      : reduced_[0];
    if (excess_.size())
    {
        excess_ = interface.filtered(filter_, interface.tangential(excess_));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::membraneMotion::predicted
(
    const membrane& body,
    const scalar dt,
    const scalar dt0,
    const bool unsteady
)
{
    const interfaceState& now = body.now();

    if (body.nOld() > 0)
    {
        const interfaceState& old = body.old(0);
        nodalVectors x = now.x + dt/dt0*(now.x - old.x);
        if (body.nOld() > 1 && !unsteady)
        {
            // Along their curved paths
            x += 0.5*dt*(1 + dt/dt0)*(now.velocity - old.velocity);
        }
        return x;
    }
    nodalVectors velocity = now.velocity;
    const nodalVectors w = excess(body, body.surface(), velocity, 0.25/dt);
    if (w.size())
    {
        velocity += w;
    }
    return now.x + dt*velocity;
}


Foam::capsule::nodalScalars Foam::capsule::membraneMotion::excess
(
    const closedSurface& curve,
    const nodalScalars& reference,
    const nodalVectors& U,
    const scalar fastest
)
{
    // Rate of change of the metric that the fluid makes
    const nodalScalars& g = curve.metric();
    const nodalVectors slope = curve.basis().derivative()*U;
    const nodalScalars rate = dot(slope, curve.tangent());
    const scalar decay = min(fastest, slope.norm()/g.norm());

    const nodalScalars change = rate + decay*g;
    nodalScalars w = curve.basis().curve().integrated
    (
        change.sum()/reference.sum()*reference - change
    );
    const nodalScalars along = dot(U, curve.tangent()) + w;
    w.array() -= curve.integral(along)/curve.perimeter();
    return w;
}


Foam::capsule::nodalVectors Foam::capsule::membraneMotion::excess
(
    const membrane& body,
    const closedSurface& surface,
    const nodalVectors& U,
    const scalar fastest
)
{
    if (body.material())
    {
        return nodalVectors(0, surface.nComponents());
    }
    if (surface.spatial())
    {
        return spatialExcess(surface, body.referenceMetric(), U, fastest);
    }
    return scaled
    (
        excess(surface, body.referenceMetric(), U, fastest), surface.tangent()
    );
}


Foam::capsule::nodalVectors Foam::capsule::membraneMotion::spatialExcess
(
    const closedSurface& surface,
    const nodalScalars& reference,
    const nodalVectors& U,
    const scalar fastest
)
{
    const sphericalBasis& basis = surface.basis().spherical();
    const nodalVectors& n = surface.normal();
    const nodalScalars J = surface.areaElement();
    const auto mean = [&](const nodalScalars& q)
    {
        return basis.weights().dot(q);
    };

    // Along the normal as the fluid, along the surface with the whole
    const nodalVectors whole =
        nodalScalars::Ones(n.rows())*(surface.flow(U)/surface.volume());
    const nodalVectors along = surface.tangential(whole);
    const nodalScalars rate =
        J.cwiseProduct(surface.divergence(scaled(dot(U, n), n) + along));
    const scalar decay = min
    (
        fastest,
        std::sqrt
        (
            surface.gradients(U).squaredNorm()/scalar(n.rows())
        )
    );
    const nodalScalars change = rate + decay*J;
    const nodalScalars wanted =
        mean(change)/mean(reference)*reference - change;

    // By the gradient of a potential on the unit sphere
    nodalScalars potential = basis.analysis().topRows(basis.nPacked())*wanted;
    potential(0) = 0;
    for (label i = 1; i < potential.size(); ++i)
    {
        const scalar l = sphericalHarmonics::degreeOf(i);
        potential(i) /= -l*(l + 1);
    }
    nodalVectors w = along - surface.tangential(U);
    for (label i = 0; i < 2; ++i)
    {
        const nodalScalars slope =
            basis.grid().derivative(i).leftCols(potential.size())*potential;
        w += scaled
        (
            slope.cwiseQuotient(J),
            nodalVectors(basis.derivative(i)*surface.nodes())
        );
    }
    return w;
}


Foam::capsule::nodalVectors Foam::capsule::membraneMotion::velocity
(
    const nodalVectors& U
) const
{
    nodalVectors result = filter_*U;
    if (conserveVolume_)
    {
        const scalar flux =
            interface_.integral(dot(result, interface_.normal()));
        result -= flux/interface_.area()*interface_.normal();
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::membraneMotion::points
(
    const nodalVectors& velocity
) const
{
    nodalVectors x = scheme_.c0*body_.old(0).x + velocity;
    if (scheme_.c00 != 0)
    {
        x -= scheme_.c00*body_.old(1).x;
    }
    if (excess_.size())
    {
        x += excess_;
    }
    x /= scheme_.c;

    if (conserveVolume_)
    {
        const closedSurface surface(body_.basis(), x);
        x +=
            (body_.referenceVolume() - surface.volume())/surface.area()
           *surface.normal();
    }
    return body_.basis().symmetric(x);
}


Foam::capsule::nodalMatrix Foam::capsule::membraneMotion::displacements
(
    const nodalMatrix& U
) const
{
    const surfaceBasis& basis = body_.basis();
    const label n = basis.nPacked();
    nodalMatrix result(U.rows(), U.cols());
    for (label i = 0; i < basis.nComponents(); ++i)
    {
        const nodalMatrix& filter = reduced_[min(i, label(1))];
        if (basis.spatial())
        {
            // Factors of the harmonics
            result.middleRows(i*n, n) =
                filter.diagonal().asDiagonal()*U.middleRows(i*n, n);
        }
        else
        {
            result.middleRows(i*n, n) = filter*U.middleRows(i*n, n);
        }
    }
    if (conserveVolume_)
    {
        result -= shift(interface_)*(volumeDerivative(interface_)*result);
    }
    return result/scheme_.c;
}


void Foam::capsule::membraneMotion::restoreVolume
(
    const closedSurface& at,
    nodalMatrix& derivative
) const
{
    if (conserveVolume_)
    {
        derivative -= (derivative*shift(at))*volumeDerivative(at);
    }
}
