/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rigidBody.H"
#include "freeSpaceResponse.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::rigidBody::excessMass
(
    const closedSurface& at
) const
{
    return (outerScale()*motion_.density() - rho_)*shape_->volumes(at);
}


Foam::capsule::nodalMatrix Foam::capsule::rigidBody::normalPart() const
{
    const label n = basis_->nPacked();
    const label d = basis_->nComponents();
    const nodalMatrix identity(nodalMatrix::Identity(n, n));
    nodalMatrix result(d*n, d*n);
    for (label i = 0; i < d; ++i)
    {
        for (label j = 0; j < d; ++j)
        {
            result.block(i*n, j*n, n, n) = basis_->multiplied
            (
                surface().normal().col(i),
                basis_->multiplied(surface().normal().col(j), identity)
            );
        }
    }
    return result;
}


void Foam::capsule::rigidBody::addInertia
(
    const nodalScalars& normal,
    const nodalScalars& flux
)
{
    const scalar l2 = rho_*flowScheme().c/mu_;
    const nodalMatrix S2 = 2*mu_*mobility_;
    const nodalMatrix one(nodalMatrix::Identity(S2.rows(), S2.cols()));
    const nodalMatrix N = normalPart();

    const nodalMatrix resistance =
        inverse_
      + 2*mu_*l2
       *((one + Foam::sqrt(l2)*S2).partialPivLu().solve(S2) + 2*N*S2*N);

    // The pressure inside lets no net flux pass
    const nodalMatrix all = resistance.inverse();
    const nodalScalars ofPressure = all*normal;
    mobility_ =
        all
      - ofPressure*(flux.transpose()*all)/flux.dot(ofPressure);
}


void Foam::capsule::rigidBody::setInverse
(
    const nodalScalars& normal,
    const nodalScalars& flux
)
{
    // A uniform pressure makes as much flux as one of a wave of the size of
    // the body would
    inverse_ =
        (
            mobility_
          + surface().meanRadius()/mu_*normal*flux.transpose()
        ).inverse();
}


void Foam::capsule::rigidBody::setResponse()
{
    const label n = nForce();
    const label m = shape_->nModes();
    const closedSurface& s = surface();
    const nodalScalars area = basis_->weights().cwiseProduct(s.areaElement());

    modes_.resize(n, m);
    resultants_.resize(m, n);
    for (label k = 0; k < m; ++k)
    {
        const nodalVectors mode = shape_->mode(s.nodes(), centre_, k);
        modes_.col(k) = basis_->pack(mode);
        resultants_.row(k) =
            basis_->packedWeights(scaled(area, mode)).transpose();
    }

    mobility_ = freeSpaceResponse::singleLayer(s, mu_);
    const nodalScalars normal = basis_->pack(s.normal());
    const nodalScalars flux =
        basis_->packedWeights(scaled(area, s.normal()))/s.area();
    setInverse(normal, flux);
    if (unsteady())
    {
        addInertia(normal, flux);
        setInverse(normal, flux);
    }
    inverse_ -= (inverse_*normal)*flux.transpose();
    resistance_ = resultants_*inverse_;

    const scalar time = mesh_.time().value();
    if (!motion_.free())
    {
        given_ = motion_.velocity(time);
        return;
    }
    given_ = outerScale()*motion_.load(time);
    nodalMatrix matrix = resistance_*modes_;
    balance_ = given_;
    if (unsteady())
    {
        const timeScheme& scheme = flowScheme();
        matrix += scheme.c*excessMass(s);
        const scalar weights[2] = {scheme.c0, -scheme.c00};
        for (label i = 0; i < 2 && weights[i] != 0; ++i)
        {
            const interfaceState& old = history_.old(i);
            balance_ += weights[i]*excessMass(surfaceOf(old))
               *shape_->velocityOf
                (
                    old.x, placeOf(old).centre, old.velocity
                );
        }
    }
    response_ = matrix.inverse();
}


Foam::capsule::nodalScalars
Foam::capsule::rigidBody::unresolvedForce() const
{
    const nodalVectors& f = history_.now().force;

    return basis_->pack(f - interface_->resolved(f));
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
    nodalScalars wanted = resistance_*y.head(n) - resultants_*y.tail(n);
    if (!change)
    {
        wanted += balance_;
    }
    return response_*wanted;
}


Foam::capsule::nodalScalars Foam::capsule::rigidBody::residual
(
    const nodalScalars& y,
    const bool change
) const
{
    return inverse_*(modes_*velocity(y, change) - y.head(nForce()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::rigidBody::fluidForce() const
{
    // The traction inside, of the liquid that moves with the body, less f
    const timeScheme& scheme = flowScheme();
    nodalScalars result(shape_->nModes());
    for (label k = 0; k < result.size(); ++k)
    {
        const nodalVectors mode = shape_->mode(surface().nodes(), centre_, k);
        result(k) = -surface().integral(dot(mode, history_.now().force));
    }
    const auto momentum = [&](const interfaceState& s)
    {
        return nodalScalars
        (
            rho_*shape_->volumes(surfaceOf(s))
           *shape_->velocityOf(s.x, placeOf(s).centre, s.velocity)
        );
    };
    if (scheme.c != 0 && history_.nOld() > 0)
    {
        result +=
            scheme.c*momentum(history_.now())
          - scheme.c0*momentum(history_.old(0));
    }
    if (scheme.c00 != 0)
    {
        result += scheme.c00*momentum(history_.old(1));
    }
    return result/outerScale();
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
    nodalScalars result(2*dx.size());
    result << mobility_*dx, dx;
    return result;
}

// ************************************************************************* //
