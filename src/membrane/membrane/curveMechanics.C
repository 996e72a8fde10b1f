/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "curveMechanics.H"
#include "resultants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::curveMechanics::tension
(
    const closedSurface& curve,
    const nodalScalars (&l)[2],
    const label i
) const
{
    nodalScalars result = law_->tension(l[i], l[1 - i]);
    if (viscosity_.valid())
    {
        for (label j = 0; j < 2; ++j)
        {
            const scalar viscosity =
                i == j ? viscosity_->along() : viscosity_->across();
            result.array() +=
                viscosity
               *(rateCoeff_ - history_[j].array()/length(curve, j).array());
        }
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::curveMechanics::viscousSlope
(
    const closedSurface& curve,
    const label i,
    const label j
) const
{
    const scalar viscosity =
        i == j ? viscosity_->along() : viscosity_->across();
    return
        viscosity*history_[j].cwiseQuotient(length(curve, j).cwiseAbs2());
}


void Foam::capsule::curveMechanics::addSecondJacobian
(
    const closedSurface& curve,
    nodalMatrix& jacobian
) const
{
    // With dg = t.dx' and dc = dr: -(T2 dg + g dT2) e
    const label n = curve.size();
    const nodalScalars l[2] = {stretch(curve), secondStretch(curve)};
    nodalScalars perLengthening =
    (
        tension(curve, l, 1)
      + l[0].cwiseProduct(law_->crossStiffness(l[1], l[0]))
    ).cwiseQuotient(curve.areaElement());
    nodalScalars stiffness =
        law_->stiffness(l[1], l[0]).cwiseQuotient
        (
            curve.around().cwiseProduct(referenceAround_)
        );
    if (viscosity_.valid())
    {
        perLengthening +=
            viscousSlope(curve, 1, 0).cwiseQuotient(curve.around());
        stiffness += viscousSlope(curve, 1, 1).cwiseQuotient(curve.around());
    }

    for (label j = 0; j < 2; ++j)
    {
        jacobian.block(n, j*n, n, n) -=
            nodalScalars
            (
                perLengthening.cwiseProduct(curve.tangent().col(j))
            ).asDiagonal()*curve.basis().derivative();
    }
    jacobian.block(n, n, n, n).diagonal() -= stiffness;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::curveMechanics::curveMechanics
(
    const dictionary& dict,
    const bool plane
)
:
    law_(elasticLaw::New(input::subDict(dict, "elasticLaw"), plane)),
    bending_(bendingModel::New(input::subDict(dict, "bending"))),
    viscosity_(surfaceViscosity::New(dict)),
    rateCoeff_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::curveMechanics::setReference
(
    const closedSurface& initial,
    const scalar stretch
)
{
    referenceMetric_ = initial.metric()/stretch;
    referenceAround_ = initial.around();
    if (initial.axisymmetric())
    {
        referenceAround_ /= stretch;
    }
    bending_->setReference(initial);
    setRates(timeScheme(), initial, initial);
}


void Foam::capsule::curveMechanics::setRates
(
    const timeScheme& scheme,
    const closedSurface& last,
    const closedSurface& lastButOne
)
{
    rateCoeff_ = scheme.c;
    for (label i = 0; i < 2; ++i)
    {
        history_[i] =
            scheme.history(length(last, i), length(lastButOne, i));
    }
}


Foam::capsule::membraneMechanics::principalValues
Foam::capsule::curveMechanics::principal(const closedSurface& curve) const
{
    const nodalScalars l[2] = {stretch(curve), secondStretch(curve)};

    return principalValues
    {
        l[0], l[1], tension(curve, l, 0), tension(curve, l, 1)
    };
}


Foam::scalar Foam::capsule::curveMechanics::elasticEnergy
(
    const closedSurface& curve
) const
{
    const surfaceBasis& basis = curve.basis();
    const nodalScalars perArea =
        law_->energy(stretch(curve), secondStretch(curve));

    return
        curve.axisymmetric()
      ? basis.weights().dot
        (
            perArea.cwiseProduct(referenceMetric_).cwiseProduct
            (
                referenceAround_
            )
        )
      : basis.spacing()*perArea.dot(referenceMetric_);
}


Foam::capsule::nodalVectors Foam::capsule::curveMechanics::force
(
    const closedSurface& curve
) const
{
    const nodalScalars l[2] = {stretch(curve), secondStretch(curve)};
    nodalVectors resultant = scaled(tension(curve, l, 0), curve.tangent());
    bending_->addResultant(curve, resultant);

    nodalVectors result = resultants::force(curve, resultant);
    if (curve.axisymmetric())
    {
        result.col(1) -= curve.metric().cwiseProduct(tension(curve, l, 1));
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::curveMechanics::forceJacobian
(
    const closedSurface& curve,
    const bool fullTangent
) const
{
    // d(T1 t) = [(dT1/dl1/g_ref - T1/g) t t + T1/g I] dx' + dT1/dl2/c_ref t dr
    const label n = curve.size();
    const bool plane = !curve.axisymmetric();
    const nodalScalars l[2] = {stretch(curve), secondStretch(curve)};
    const nodalScalars T1 = tension(curve, l, 0);
    nodalScalars along =
        law_->stiffness(l[0], l[1]).cwiseQuotient(referenceMetric_);
    nodalScalars across =
        plane
      ? nodalScalars()
      : law_->crossStiffness(l[0], l[1]).cwiseQuotient(referenceAround_);
    if (viscosity_.valid())
    {
        along += viscousSlope(curve, 0, 0);
        if (!plane)
        {
            across += viscousSlope(curve, 0, 1);
        }
    }
    const nodalScalars turning =
        (
            fullTangent ? T1 : nodalScalars(T1.cwiseMax(0))
        ).cwiseQuotient(curve.metric());
    const nodalVectors& t = curve.tangent();
    const nodalMatrix& d = curve.basis().derivative();

    nodalMatrix result(2*n, 2*n);
    for (label i = 0; i < 2; ++i)
    {
        for (label j = 0; j < 2; ++j)
        {
            if (plane && j < i)
            {
                result.block(i*n, j*n, n, n) = result.block(j*n, i*n, n, n);
                continue;
            }
            nodalScalars m =
                (along - turning).array()*t.col(i).array()*t.col(j).array();
            if (i == j)
            {
                m += turning;
            }
            nodalMatrix change = m.asDiagonal()*d;
            if (j == 1 && !plane)
            {
                change.diagonal() += across.cwiseProduct(t.col(i));
            }
            result.block(i*n, j*n, n, n) = resultants::forceChange
            (
                curve, T1.cwiseProduct(t.col(i)), change, j
            );
        }
    }
    if (!plane)
    {
        addSecondJacobian(curve, result);
    }
    bending_->addJacobian(curve, result);
    return curve.basis().curve().reduced(result);
}
