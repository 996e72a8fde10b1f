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

void Foam::capsule::curveMechanics::addSecondJacobian
(
    const closedSurface& curve,
    nodalMatrix& jacobian
) const
{
    // With dg = t.dx' and dc = dr: -(T2 dg + g dT2) e
    const label n = curve.size();
    const nodalScalars l1 = stretch(curve);
    const nodalScalars l2 = secondStretch(curve);
    const nodalScalars perLengthening =
    (
        law_->tension(l2, l1) + l1.cwiseProduct(law_->crossStiffness(l2, l1))
    ).cwiseQuotient(curve.areaElement());

    for (label j = 0; j < 2; ++j)
    {
        jacobian.block(n, j*n, n, n) -=
            nodalScalars
            (
                perLengthening.cwiseProduct(curve.tangent().col(j))
            ).asDiagonal()*curve.basis().derivative();
    }
    jacobian.block(n, n, n, n).diagonal() -=
        law_->stiffness(l2, l1).cwiseQuotient
        (
            curve.around().cwiseProduct(referenceAround_)
        );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::curveMechanics::curveMechanics
(
    const dictionary& dict,
    const bool plane
)
:
    law_(elasticLaw::New(input::subDict(dict, "elasticLaw"), plane)),
    bending_(bendingModel::New(input::subDict(dict, "bending")))
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
}


Foam::capsule::membraneMechanics::principalValues
Foam::capsule::curveMechanics::principal(const closedSurface& curve) const
{
    const nodalScalars l1 = stretch(curve);
    const nodalScalars l2 = secondStretch(curve);

    return principalValues
    {
        l1, l2, law_->tension(l1, l2), law_->tension(l2, l1)
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
    const nodalScalars l1 = stretch(curve);
    const nodalScalars l2 = secondStretch(curve);
    nodalVectors resultant = scaled(law_->tension(l1, l2), curve.tangent());
    bending_->addResultant(curve, resultant);

    nodalVectors result = resultants::force(curve, resultant);
    if (curve.axisymmetric())
    {
        result.col(1) -= curve.metric().cwiseProduct(law_->tension(l2, l1));
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
    const nodalScalars l1 = stretch(curve);
    const nodalScalars l2 = secondStretch(curve);
    const nodalScalars T1 = law_->tension(l1, l2);
    const nodalScalars along =
        law_->stiffness(l1, l2).cwiseQuotient(referenceMetric_);
    const nodalScalars across =
        plane
      ? nodalScalars()
      : law_->crossStiffness(l1, l2).cwiseQuotient(referenceAround_);
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
