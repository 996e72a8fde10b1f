/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "momentumLayer.H"
#include "membrane.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::momentumLayer::memory_ = 6;

const Foam::scalar Foam::capsule::momentumLayer::leastTime_ = 2;

const Foam::scalar Foam::capsule::momentumLayer::leastAmplitude_ = 0.01;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::momentumLayer::rate() const
{
    return std::sqrt(max(acceleration_, scalar(0))/(speed_ + VSMALL));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::momentumLayer::momentumLayer()
:
    time_(0),
    speed_(0),
    acceleration_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::momentumLayer::add(const membrane& body, const scalar dt)
{
    // The start knows no velocity
    if (body.nOld() < 2 || body.old(1).velocity.isZero())
    {
        return;
    }
    const auto relative = [](const nodalVectors& U)
    {
        return nodalVectors(U.rowwise() - U.colwise().mean());
    };
    const nodalVectors U = relative(body.now().velocity);
    const nodalVectors U0 = relative(body.old(0).velocity);
    const nodalVectors U00 = relative(body.old(1).velocity);

    const scalar kept = std::exp(-dt*rate()/memory_);
    time_ = kept*time_ + dt;
    speed_ = kept*speed_ + dt*U.squaredNorm()/body.size();
    acceleration_ =
        kept*acceleration_
      + (U - U0).cwiseProduct(U0 - U00).sum()/dt/body.size();
}


Foam::scalar Foam::capsule::momentumLayer::thickness
(
    const membrane& body,
    const scalar nu,
    const scalar width
) const
{
    const closedSurface surface(body.surface());
    nodalVectors U = body.now().velocity;
    const nodalVectors x = surface.nodes().rowwise() - surface.centroid();
    for (label k = 0; k < surface.nRotations(); ++k)
    {
        // Without the rotation as a whole
        const nodalVectors turn = turned(x, k);
        U -=
            surface.integral(dot(U, turn))/surface.integral(dot(turn, turn))
           *turn;
    }
    scalar omega = std::sqrt
    (
        surface.integral(surface.gradients(U).rowwise().squaredNorm())
       /surface.area()
    );

    const scalar inTime = rate();
    const scalar speed = std::sqrt(speed_/(time_ + VSMALL));
    if
    (
        inTime*time_ > leastTime_
     && speed > leastAmplitude_*width*inTime
    )
    {
        omega = max(omega, inTime);
    }
    return omega > VSMALL ? std::sqrt(2*nu/omega) : GREAT;
}
