/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "jumpConditions.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Columns of the coefficients: derivatives in the distance d at d = 0, and
//  their derivatives along the curve
enum term
{
    U1 = 0,         // of u, two components each
    U2 = 2,
    P0 = 4,         // of p
    P1,
    P2,
    S0,             // d/ds of P0, P1
    S1,
    KAPPA,
    US              // d/ds of U1
};

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::jumpConditions::footPoints::footPoints
(
    const closedSurface& curve,
    const nodalScalars& alpha,
    const nodalScalars& d
)
:
    functions(curve.basis().functions(alpha)),
    normal(alpha.size(), 2),
    distance(d)
{
    for (Eigen::Index i = 0; i < alpha.size(); ++i)
    {
        normal.row(i) = turned(curve.point(alpha(i), 1)).normalized();
    }
}


Foam::capsule::jumpConditions::jumpConditions
(
    const closedSurface& curve,
    const nodalVectors& f,
    const nodalVectors& m,
    const nodalScalars& c,
    const scalar mu
)
:
    terms_(curve.size(), 12)
{
    const nodalVectors& n = curve.normal();
    const nodalVectors& t = curve.tangent();
    const nodalScalars& kappa = curve.curvature();
    const auto times = [](const nodalScalars& x, const nodalScalars& y)
    {
        return nodalScalars(x.cwiseProduct(y));
    };

    const nodalScalars b = -dot(f, t)/mu;
    const nodalScalars b1 = curve.divergence(b);

    const nodalScalars p0 = dot(f, n);
    const nodalScalars p0s = curve.ds(p0);
    const nodalScalars p1 = -mu*b1 - dot(m, n);
    const nodalScalars H = curve.totalCurvature();
    const nodalScalars p2 = c - curve.divergence(p0s) - times(H, p1);

    terms_.middleCols<2>(U1) = scaled(b, t);
    terms_.middleCols<2>(U2) =
        scaled(-b1, n) + scaled((p0s + dot(m, t))/mu - times(H, b), t);
    terms_.col(P0) = p0;
    terms_.col(P1) = p1;
    terms_.col(P2) = p2;
    terms_.col(S0) = p0s;
    terms_.col(S1) = curve.ds(p1);
    terms_.col(KAPPA) = kappa;
    terms_.middleCols<2>(US) = curve.ds(scaled(b, t));
    terms_ = (curve.basis().analysis()*terms_).eval();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::jumpConditions::velocity
(
    const footPoints& at
) const
{
    const nodalMatrix u = at.functions*terms_.middleCols<4>(U1);
    const nodalScalars& d = at.distance;

    return scaled(d, u.leftCols(2)) + scaled(d.cwiseAbs2()/2, u.rightCols(2));
}


Foam::capsule::nodalVectors Foam::capsule::jumpConditions::velocityCurvature
(
    const footPoints& at,
    const nodalVectors& d
) const
{
    const nodalMatrix u = at.functions*terms_;
    const nodalScalars n = dot(d, at.normal);
    const nodalScalars t =
        d.col(1).cwiseProduct(at.normal.col(0))
      - d.col(0).cwiseProduct(at.normal.col(1));

    return
        scaled(n.cwiseAbs2(), u.middleCols<2>(U2))
      + scaled(2*n.cwiseProduct(t), u.middleCols<2>(US))
      + scaled
        (
            t.cwiseAbs2().cwiseProduct(u.col(KAPPA)), u.middleCols<2>(U1)
        );
}


Foam::capsule::nodalScalars Foam::capsule::jumpConditions::pressure
(
    const footPoints& at
) const
{
    const nodalMatrix p = at.functions*terms_.middleCols<3>(P0);
    const nodalScalars& d = at.distance;

    return p.col(0) + d.cwiseProduct(p.col(1) + d.cwiseProduct(p.col(2))/2);
}


Foam::capsule::nodalVectors Foam::capsule::jumpConditions::pressureGradient
(
    const footPoints& at
) const
{
    const nodalMatrix p = at.functions*terms_.middleCols<5>(P1);
    const nodalScalars& d = at.distance;
    const nodalScalars normal = p.col(0) + d.cwiseProduct(p.col(1));

    // Along the parallel curve, longer by the factor 1 + kappa d
    const nodalScalars stretched =
        nodalScalars::Ones(d.size()) + p.col(4).cwiseProduct(d);
    const nodalScalars along =
        (p.col(2) + d.cwiseProduct(p.col(3))).cwiseQuotient(stretched);

    nodalVectors t(at.normal.rows(), 2);
    t.col(0) = -at.normal.col(1);
    t.col(1) = at.normal.col(0);

    return scaled(normal, at.normal) + scaled(along, t);
}
