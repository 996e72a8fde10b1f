/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rigidBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::rigidBody::velocityOf
(
    const interfaceState& s
) const
{
    return shape_->velocityOf(s.x, placeOf(s).centre, s.velocity);
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::momentum
(
    const interfaceState& s
) const
{
    return
        shape_->volumes(closedSurface(*basis_, s.x))*velocityOf(s);
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::oldMomentum() const
{
    const timeScheme& scheme = flowScheme();
    nodalScalars result(nodalScalars::Zero(shape_->nModes()));
    if (scheme.c0 != 0)
    {
        result += scheme.c0*momentum(history_.old(0));
    }
    if (scheme.c00 != 0)
    {
        result -= scheme.c00*momentum(history_.old(1));
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::fluxVelocity() const
{
    nodalScalars result = velocityOf(history_.old(0));
    if (history_.nOld() > 1)
    {
        const Time& time = mesh_.time();
        result +=
            time.deltaTValue()/time.deltaT0Value()
           *(result - velocityOf(history_.old(1)));
    }
    return result;
}


void Foam::capsule::rigidBody::setResponse()
{
    const label n = nForce();
    const label m = shape_->nModes();
    const closedSurface& s = surface();
    const nodalScalars area = basis_->weights().cwiseProduct(s.areaElement());
    const scalar c = flowScheme().c;

    modes_.resize(n, m);
    nodalMatrix resultants(m, n);
    for (label k = 0; k < m; ++k)
    {
        const nodalVectors mode = shape_->mode(s.nodes(), centre_, k);
        modes_.col(k) = basis_->pack(mode);
        resultants.row(k) =
            basis_->packedWeights(scaled(area, mode)).transpose();
    }
    slip_ = slipResponse(s, around_.mu(), around_.rho()*c);
    taken_ = given_ = nodalScalars::Zero(m);

    const scalar time = mesh_.time().value();
    if (!motion_.free())
    {
        given_ = motion_.velocity(time);
        return;
    }
    const scalar density = around_.scale()*motion_.density();
    balance_ = rigidBalance
    (
        modes_,
        resultants,
        slip_,
        density*c*shape_->volumes(s),
        around_.scale()*motion_.load(time) + density*oldMomentum()
    );
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::velocity
(
    const nodalScalars& y,
    const bool change
) const
{
    const label n = nForce();
    if (!motion_.free())
    {
        return change ? nodalScalars(0*given_) : given_;
    }
    return balance_.velocity
    (
        y.head(n),
        y.segment(n, n),
        counted() ? nodalScalars(y.tail(taken_.size())) : taken_,
        change
    );
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::residual
(
    const nodalScalars& y,
    const bool change
) const
{
    return slip_.force()*(modes_*velocity(y, change) - y.head(nForce()));
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::carried
(
    const nodalScalars& U
) const
{
    return motion_.free() ? nodalScalars(balance_.carried(U)) : given_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::capsule::rigidBody::nResponse() const
{
    return 2*nForce() + (counted() ? taken_.size() : 0);
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::unknowns() const
{
    return basis_->pack(history_.now().force);
}


void Foam::capsule::rigidBody::setUnknowns(const nodalScalars& x)
{
    history_.now().force = basis_->unpack(x);
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::fluidForce() const
{
    // The traction inside less f
    const label m = shape_->nModes();
    nodalScalars result = taken_;
    if (!result.size())
    {
        // No step has been taken: with inertia the liquid inside is not known
        result = nodalScalars::Constant(m, unsteady() ? std::nan("") : 0);
    }
    for (label k = 0; k < m; ++k)
    {
        const nodalVectors mode = shape_->mode(surface().nodes(), centre_, k);
        result(k) -= surface().integral(dot(mode, history_.now().force));
    }
    return result/around_.scale();
}


Foam::scalar Foam::capsule::rigidBody::power() const
{
    const interfaceState& now = history_.now();
    scalar result = surface().integral(dot(now.force, now.velocity));
    if (unsteady() && taken_.size())
    {
        const nodalScalars delay =
            around_.rho()*(flowScheme().c*momentum(now) - oldMomentum()) - taken_;
        result += delay.dot(velocity());
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::rigidBody::residualChange
(
    const nodalMatrix& dy
) const
{
    nodalMatrix result(nForce(), dy.cols());
    for (label j = 0; j < dy.cols(); ++j)
    {
        result.col(j) = residual(dy.col(j), true);
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::responseChange
(
    const nodalScalars& dx
) const
{
    nodalScalars result(nResponse());
    result.head(2*dx.size()) << slip_.velocity()*dx, dx;
    if (counted())
    {
        result.tail(taken_.size()) = balance_.insideChange(dx);
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::rigidBody::pointsOf
(
    const nodalScalars& y
) const
{
    return shape_->nodes(moved(carried(y.head(nForce()))));
}


Foam::capsule::nodalMatrix Foam::capsule::rigidBody::pointsChange
(
    const nodalMatrix& dy
) const
{
    const label n = nForce();
    if (!motion_.free())
    {
        return nodalMatrix::Zero(n, dy.cols());
    }
    return modes_*balance_.carried(dy.topRows(n))/motionScheme().c;
}


Foam::capsule::nodalMatrix Foam::capsule::rigidBody::loaded
(
    const nodalMatrix& forces
) const
{
    if (!motion_.free())
    {
        return nodalMatrix::Zero(nForce(), forces.cols());
    }
    return
        slip_.force()*(modes_*balance_.loaded(around_.scale()*forces));
}


// ************************************************************************* //
