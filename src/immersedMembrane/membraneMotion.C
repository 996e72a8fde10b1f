/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneMotion.H"

const Foam::scalar Foam::capsule::membraneMotion::waves = 3;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::membraneMotion::volumeDerivative
(
    const closedSurface& curve
)
{
    // Of all nodes, in the unknowns of those that count
    const surfaceBasis& basis = curve.basis();
    const scalar images = scalar(basis.size())/basis.nPacked();
    return images*basis.pack(curve.volumeDerivative()).transpose();
}


Foam::capsule::nodalScalars Foam::capsule::membraneMotion::shift
(
    const closedSurface& curve
)
{
    return curve.basis().pack(curve.normal())/curve.surface();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneMotion::membraneMotion
(
    const membrane& body,
    const closedSurface& interface,
    const closedSurface& predicted,
    const nodalMatrix& filter,
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
    if (excess_.size())
    {
        excess_ = filter_*excess_;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    nodalScalars w = curve.basis().integrated
    (
        change.sum()/reference.sum()*reference - change
    );
    const nodalScalars along = dot(U, curve.tangent()) + w;
    w.array() -= curve.integral(along)/curve.perimeter();
    return w;
}


Foam::capsule::nodalScalars Foam::capsule::membraneMotion::excess
(
    const membrane& body,
    const closedSurface& curve,
    const nodalVectors& U,
    const scalar fastest
)
{
    if (body.material())
    {
        return nodalScalars();
    }
    return excess(curve, body.referenceMetric(), U, fastest);
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
        result -= flux/interface_.surface()*interface_.normal();
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
        x += scaled(excess_, interface_.tangent());
    }
    x /= scheme_.c;

    if (conserveVolume_)
    {
        const closedSurface curve(body_.basis(), x);
        x +=
            (body_.referenceVolume() - curve.volume())/curve.surface()
           *curve.normal();
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
    nodalMatrix result(2*n, U.cols());
    for (label i = 0; i < 2; ++i)
    {
        result.middleRows(i*n, n) =
            basis.reduced(filter_, i)*U.middleRows(i*n, n);
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
