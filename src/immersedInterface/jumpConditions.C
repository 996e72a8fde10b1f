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

//- Columns of the coefficients
enum term
{
    UN,             // du/dn, two components
    UNN = 2,        // d2u/dn2, two components
    P = 4,          // p
    PN,             // dp/dn
    PNN,            // d2p/dn2
    PT,             // dp/ds
    PNT             // d2p/dnds
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
    terms_(curve.size(), 9)
{
    const nodalVectors& n = curve.normal();
    const nodalVectors& t = curve.tangent();
    const nodalScalars& kappa = curve.curvature();

    const nodalScalars p = dot(f, n);
    const nodalScalars p1 = curve.ds(p);
    const nodalScalars b = -dot(f, t)/mu;
    const nodalScalars b1 = curve.ds(b);
    const nodalScalars pn = -mu*b1 - dot(m, n);

    terms_.middleCols<2>(UN) = scaled(b, t);
    terms_.middleCols<2>(UNN) =
        scaled(-b1, n)
      + scaled((p1 + dot(m, t))/mu - kappa.cwiseProduct(b), t);
    terms_.col(P) = p;
    terms_.col(PN) = pn;
    terms_.col(PNN) = -curve.ds(p1) - kappa.cwiseProduct(pn);
    terms_.col(PT) = p1;
    terms_.col(PNT) = curve.ds(pn) - kappa.cwiseProduct(p1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::jumpConditions::velocity
(
    const targets& at
) const
{
    const nodalMatrix terms =
        at.interpolation*terms_.middleCols<4>(UN);
    const nodalScalars half = 0.5*at.distance.array().square().matrix();

    return scaled(at.distance, terms.leftCols(2))
      + scaled(half, terms.rightCols(2));
}


Foam::capsule::nodalScalars Foam::capsule::jumpConditions::pressure
(
    const targets& at
) const
{
    const nodalMatrix terms = at.interpolation*terms_.middleCols<3>(P);
    const auto d = at.distance.array();

    return
    (
        terms.col(0).array()
      + d*(terms.col(1).array() + 0.5*d*terms.col(2).array())
    ).matrix();
}


Foam::capsule::nodalVectors Foam::capsule::jumpConditions::pressureGradient
(
    const targets& at
) const
{
    const nodalMatrix terms = at.interpolation*terms_.middleCols<4>(PN);
    const auto d = at.distance.array();
    const nodalScalars normal =
        (terms.col(0).array() + d*terms.col(1).array()).matrix();
    const nodalScalars along =
        (terms.col(2).array() + d*terms.col(3).array()).matrix();

    nodalVectors t(at.normal.rows(), 2);
    t.col(0) = -at.normal.col(1);
    t.col(1) = at.normal.col(0);

    return scaled(normal, at.normal) + scaled(along, t);
}
