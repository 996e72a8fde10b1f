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
    U3 = 4,
    P0 = 6,         // of p
    P1,
    P2,
    P3,
    S0,             // d/ds of P0, P1, P2
    S1,
    S2,
    KAPPA
};

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::jumpConditions::targets::targets
(
    const closedCurve& curve,
    const nodalScalars& alpha,
    const nodalScalars& d
)
:
    interpolation(curve.basis().evaluation(alpha)),
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
    const closedCurve& curve,
    const nodalVectors& f,
    const nodalVectors& m,
    const scalar mu
)
:
    terms_(curve.size(), 14)
{
    const nodalVectors& n = curve.normal();
    const nodalVectors& t = curve.tangent();
    const nodalScalars& kappa = curve.curvature();
    const nodalScalars kappa2 = kappa.cwiseAbs2();
    const auto times = [](const nodalScalars& x, const nodalScalars& y)
    {
        return nodalScalars(x.cwiseProduct(y));
    };

    const nodalScalars b = -dot(f, t)/mu;
    const nodalScalars b1 = curve.ds(b);

    const nodalScalars p0 = dot(f, n);
    const nodalScalars p0s = curve.ds(p0);
    const nodalScalars p0ss = curve.ds(p0s);
    const nodalScalars p1 = -mu*b1 - dot(m, n);
    const nodalScalars p1s = curve.ds(p1);
    const nodalScalars p2 = -p0ss - times(kappa, p1);
    const nodalScalars p3 =
        times(kappa2, p1) - times(kappa, p2) - curve.ds(p1s)
      + 2*times(kappa, p0ss) + times(curve.ds(kappa), p0s);

    const nodalVectors u1 = scaled(b, t);
    const nodalVectors u2 =
        scaled(-b1, n) + scaled((p0s + dot(m, t))/mu - times(kappa, b), t);
    const nodalVectors u3 =
        (scaled(p2, n) + scaled(p1s - times(kappa, p0s), t))/mu
      - scaled(kappa, u2) + scaled(kappa2, u1) - curve.ds(curve.ds(u1));

    terms_.middleCols<2>(U1) = u1;
    terms_.middleCols<2>(U2) = u2;
    terms_.middleCols<2>(U3) = u3;
    terms_.col(P0) = p0;
    terms_.col(P1) = p1;
    terms_.col(P2) = p2;
    terms_.col(P3) = p3;
    terms_.col(S0) = p0s;
    terms_.col(S1) = p1s;
    terms_.col(S2) = curve.ds(p2);
    terms_.col(KAPPA) = kappa;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::jumpConditions::velocity
(
    const targets& at
) const
{
    const nodalMatrix u = at.interpolation*terms_.middleCols<6>(U1);
    const nodalScalars& d = at.distance;
    const nodalScalars d2 = d.cwiseAbs2()/2;
    const nodalScalars d3 = d2.cwiseProduct(d)/3;

    return scaled(d, u.leftCols(2))
      + scaled(d2, u.middleCols(2, 2))
      + scaled(d3, u.rightCols(2));
}


Foam::capsule::nodalScalars Foam::capsule::jumpConditions::pressure
(
    const targets& at
) const
{
    const nodalMatrix p = at.interpolation*terms_.middleCols<4>(P0);
    const nodalScalars& d = at.distance;
    const nodalScalars d2 = d.cwiseAbs2()/2;
    const nodalScalars d3 = d2.cwiseProduct(d)/3;

    return p.col(0) + d.cwiseProduct(p.col(1)) + d2.cwiseProduct(p.col(2))
      + d3.cwiseProduct(p.col(3));
}


Foam::capsule::nodalVectors Foam::capsule::jumpConditions::pressureGradient
(
    const targets& at
) const
{
    const nodalMatrix p = at.interpolation*terms_.middleCols<7>(P1);
    const nodalScalars& d = at.distance;
    const nodalScalars d2 = d.cwiseAbs2()/2;

    const nodalScalars normal =
        p.col(0) + d.cwiseProduct(p.col(1)) + d2.cwiseProduct(p.col(2));

    // Along the parallel curve, longer by the factor 1 + kappa d
    const nodalScalars along =
    (
        p.col(3) + d.cwiseProduct(p.col(4)) + d2.cwiseProduct(p.col(5))
    ).cwiseQuotient
    (
        nodalScalars::Ones(d.size()) + p.col(6).cwiseProduct(d)
    );

    nodalVectors t(at.normal.rows(), 2);
    t.col(0) = -at.normal.col(1);
    t.col(1) = at.normal.col(0);

    return scaled(normal, at.normal) + scaled(along, t);
}
