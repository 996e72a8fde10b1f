/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceMechanics.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::surfaceMetric Foam::capsule::surfaceMechanics::metricOf
(
    const sphericalGrid& grid,
    const nodalVectors& X
)
{
    return surfaceMetric(grid.derivative(0)*X, grid.derivative(1)*X);
}


Foam::capsule::surfaceBending::nodalJets
Foam::capsule::surfaceMechanics::jetsOf(const nodalVectors& X) const
{
    return
    {
        grid_.derivative(0)*X,
        grid_.derivative(1)*X,
        grid_.secondDerivative(0, 0)*X,
        grid_.secondDerivative(0, 1)*X,
        grid_.secondDerivative(1, 1)*X
    };
}


Foam::capsule::secondPiolaStress Foam::capsule::surfaceMechanics::stressOf
(
    const surfaceMetric& surface
) const
{
    return law_->stress
    (
        reference_.firstInvariant(surface),
        reference_.areaRatio(surface)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surfaceMechanics::surfaceMechanics
(
    const dictionary& dict,
    const label degree,
    const scalar oversampling
)
:
    law_(elasticLaw::New(input::subDict(dict, "elasticLaw"), false)),
    bending_(bendingModel::New(input::subDict(dict, "bending"))->inSpace()),
    harmonics_(degree),
    grid_
    (
        harmonics_,
        label(std::ceil(oversampling*degree)),
        bending_.valid() ? 2 : 1
    ),
    products_(grid_, degree, bending_.valid() ? 5 : 2),
    viscosity_(surfaceViscosity::New(dict))
{
    // Any three coordinates of the unit sphere in space
    nodalVectors sphere = nodalVectors::Zero(harmonics_.size(), 3);
    sphere(2, 0) = sphere(3, 1) = sphere(1, 2) = 1/std::sqrt(scalar(3));
    setReference(sphere, 1);
    setRates(timeScheme(), sphere, sphere);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::surfaceMechanics::setReference
(
    const nodalVectors& initial,
    const scalar stretch
)
{
    referenceShape_ = initial/stretch;
    reference_ = metricOf(grid_, referenceShape_);
    if (bending_.valid())
    {
        bending_->setReference(jetsOf(initial));
    }
}


Foam::scalar Foam::capsule::surfaceMechanics::elasticEnergy
(
    const nodalVectors& X
) const
{
    const principalValues values = principal(grid_, X);

    return
        law_->energy(values.l1, values.l2).cwiseProduct(reference_.area()).dot
        (
            grid_.weights()
        );
}


Foam::scalar Foam::capsule::surfaceMechanics::bendingEnergy
(
    const nodalVectors& X
) const
{
    return
        bending_.valid()
      ? bending_->energy(jetsOf(X)).dot(grid_.weights())
      : 0;
}


Foam::capsule::nodalVectors Foam::capsule::surfaceMechanics::force
(
    const nodalVectors& X
) const
{
    const nodalScalars weights = grid_.weights()/(-4*pi);
    const surfaceMetric surface = metricOf(grid_, X);
    const secondPiolaStress stress = stressOf(surface);
    const nodalScalars perArea = weights.cwiseProduct(reference_.area());

    nodalVectors result = nodalVectors::Zero(X.rows(), 3);
    for (label a = 0; a < 2; ++a)
    {
        nodalVectors resultant = nodalVectors::Zero(grid_.size(), 3);
        for (label b = 0; b < 2; ++b)
        {
            const nodalScalars S =
                stress.alpha.cwiseProduct(reference_.inverse(a, b))
              + stress.beta.cwiseProduct(surface.inverse(a, b));
            resultant += scaled(S.cwiseProduct(perArea), surface.tangent(b));
        }
        result += grid_.derivative(a).transpose()*resultant;
    }

    if (viscosity_.valid())
    {
        addViscousForce(surface, result);
    }
    if (bending_.valid())
    {
        const surfaceBending::nodalJets g = bending_->gradient(jetsOf(X));
        for (label a = 0; a < 5; ++a)
        {
            const nodalMatrix& d =
                a < 2
              ? grid_.derivative(a)
              : grid_.secondDerivative((a - 2)/2, (a - 1)/2);
            result += d.transpose()*scaled(weights, g[a]);
        }
    }
    return result;
}


Foam::capsule::surfaceMechanics::principalValues
Foam::capsule::surfaceMechanics::principal
(
    const sphericalGrid& grid,
    const nodalVectors& X
) const
{
    const surfaceMetric reference = metricOf(grid, referenceShape_);
    const surfaceMetric surface = metricOf(grid, X);
    const nodalScalars I = reference.firstInvariant(surface);
    const nodalScalars J = reference.areaRatio(surface);

    // (l1 + l2)^2 = I + 2 J, (l1 - l2)^2 = I - 2 J
    const nodalScalars sum = (I + 2*J).cwiseSqrt();
    const nodalScalars difference = (I - 2*J).cwiseMax(0).cwiseSqrt();

    principalValues result;
    result.l1 = 0.5*(sum + difference);
    result.l2 = 0.5*(sum - difference);
    result.T1 = law_->tension(result.l1, result.l2);
    result.T2 = law_->tension(result.l2, result.l1);
    if (viscosity_.valid())
    {
        addViscousTensions(grid, reference, surface, result);
    }

    return result;
}


// ************************************************************************* //
