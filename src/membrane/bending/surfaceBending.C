/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceBending.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::surfaceBending::jet Foam::capsule::surfaceBending::jetAt
(
    const nodalJets& x,
    const label node
)
{
    jet result;
    for (label a = 0; a < 5; ++a)
    {
        result.col(a) = x[a].row(node).transpose();
    }
    return result;
}


Foam::capsule::surfaceBending::bend Foam::capsule::surfaceBending::bendAt
(
    const label node,
    const forms& f
) const
{
    // With D = a^-1 da: dL = a^-1 dkappa - D L
    bend result;
    result.L = f.inverse*f.curvature;
    if (initial_)
    {
        result.L -= f.symmetric(reference_[node]);
    }

    for (label i = 0; i < 3; ++i)
    {
        tensor2 unit;
        unit << (i == 0), (i == 1), (i == 1), (i == 2);
        const tensor2 D = f.inverse*unit;

        result.D[i] = D;
        result.D[3 + i].setZero();
        result.dL[i] = -D*result.L;
        result.dL[3 + i] = D;
        if (initial_)
        {
            const tensor2& R = reference_[node];
            result.dL[i] -=
                0.5*(D*R + f.inverse*R.transpose()*f.metric*D);
        }
    }
    return result;
}


Foam::scalar Foam::capsule::surfaceBending::value(const tensor2& L) const
{
    return initial_ ? (L*L).trace() : sqr(L.trace() - 2*uniform_);
}


Foam::scalar Foam::capsule::surfaceBending::slope
(
    const tensor2& L,
    const tensor2& dL
) const
{
    return
        initial_
      ? 2*(L*dL).trace()
      : 2*(L.trace() - 2*uniform_)*dL.trace();
}


Foam::scalar Foam::capsule::surfaceBending::convexity
(
    const tensor2& dL,
    const tensor2& dL2
) const
{
    return initial_ ? 2*(dL*dL2).trace() : 2*dL.trace()*dL2.trace();
}


Foam::capsule::surfaceBending::slopes
Foam::capsule::surfaceBending::firstDerivative
(
    const forms& f,
    const bend& b
) const
{
    // dA = A tr D/2
    slopes result;
    for (label i = 0; i < 6; ++i)
    {
        result(i) = 0.5*b.D[i].trace()*value(b.L) + slope(b.L, b.dL[i]);
    }
    return 0.5*modulus_*f.area*result;
}


Foam::capsule::surfaceBending::curvings
Foam::capsule::surfaceBending::secondDerivative
(
    const forms& f,
    const bend& b
) const
{
    // d2A = A ((tr D)^2/4 - tr D^2/2), d2L = -2 D dL
    curvings result;
    for (label i = 0; i < 6; ++i)
    {
        const scalar di = 0.5*b.D[i].trace();
        for (label j = 0; j <= i; ++j)
        {
            const scalar dj = 0.5*b.D[j].trace();

            result(i, j) = result(j, i) =
                (di*dj - 0.5*(b.D[i]*b.D[j]).trace())*value(b.L)
              + di*slope(b.L, b.dL[j])
              + dj*slope(b.L, b.dL[i])
              + convexity(b.dL[i], b.dL[j])
              - slope(b.L, b.D[i]*b.dL[j] + b.D[j]*b.dL[i]);
        }
    }
    return 0.5*modulus_*f.area*result;
}


Foam::capsule::surfaceBending::curvings
Foam::capsule::surfaceBending::positivePart
(
    const forms& f,
    const bend& b
) const
{
    curvings result;
    for (label i = 0; i < 6; ++i)
    {
        for (label j = 0; j <= i; ++j)
        {
            result(i, j) = result(j, i) =
                convexity(f.symmetric(b.dL[i]), f.symmetric(b.dL[j]));
        }
    }
    return 0.5*modulus_*f.area*result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surfaceBending::surfaceBending
(
    const scalar modulus,
    const bool initial,
    const scalar uniform
)
:
    modulus_(modulus),
    initial_(initial),
    uniform_(uniform)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::surfaceBending::setReference(const nodalJets& initial)
{
    if (!initial_)
    {
        return;
    }
    reference_.resize(initial[0].rows());
    forAll(reference_, node)
    {
        const forms f(jetAt(initial, node));
        reference_[node] = f.inverse*f.curvature;
    }
}


Foam::capsule::nodalScalars Foam::capsule::surfaceBending::energy
(
    const nodalJets& x
) const
{
    nodalScalars result(x[0].rows());
    for (label node = 0; node < result.size(); ++node)
    {
        const forms f(jetAt(x, node));
        result(node) = 0.5*modulus_*f.area*value(bendAt(node, f).L);
    }
    return result;
}


Foam::capsule::surfaceBending::nodalJets
Foam::capsule::surfaceBending::gradient(const nodalJets& x) const
{
    nodalJets result(x);
    for (label node = 0; node < x[0].rows(); ++node)
    {
        const jet y = jetAt(x, node);
        const forms f(y);
        const Eigen::Matrix<scalar, 15, 1> g =
            f.change(y).transpose()*firstDerivative(f, bendAt(node, f));

        for (label a = 0; a < 5; ++a)
        {
            result[a].row(node) = g.segment<3>(3*a).transpose();
        }
    }
    return result;
}


Foam::capsule::surfaceBending::hessianMatrix
Foam::capsule::surfaceBending::hessian
(
    const nodalJets& x,
    const label node,
    const bool whole
) const
{
    const jet y = jetAt(x, node);
    const forms f(y);
    const bend b = bendAt(node, f);
    const Eigen::Matrix<scalar, 6, 15> change = f.change(y);

    if (!whole)
    {
        return change.transpose()*positivePart(f, b)*change;
    }
    return
        change.transpose()*secondDerivative(f, b)*change
      + f.secondChange(firstDerivative(f, b));
}


// ************************************************************************* //
