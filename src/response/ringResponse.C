/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "ringResponse.H"
#include "ringIntegrals.H"
#include "meridianWaves.H"
#include "GaussRule.H"
#include "DynamicList.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- A 2 x 2 kernel: row of the point's component, column of the force's
typedef Eigen::Matrix<scalar, 2, 2> kernelValue;

//- A point of integration: distance from the node in theta, and weight
struct rulePoint
{
    scalar offset;
    scalar weight;
};

//- Rule of Gauss and Legendre on (0, 1)
static List<rulePoint> unitRule(const label n)
{
    const GaussRule Gauss(n);
    List<rulePoint> rule(n);
    for (label k = 0; k < n; ++k)
    {
        rule[k].offset = 0.5*(1 + Gauss.node(k));
        rule[k].weight = 0.5*Gauss.weight(k);
    }
    return rule;
}


//- Append points on one side of a node, from it to the axis at a distance, see
//  the header
static void addPanels
(
    const List<rulePoint>& Gauss,
    const scalar direction,
    const scalar toAxis,
    const scalar first,
    const scalar longest,
    DynamicList<rulePoint>& rule
)
{
    for (const rulePoint& p : Gauss)
    {
        const scalar t5 = pow5(p.offset);
        rule.append
        (
            rulePoint{direction*first*t5*p.offset, 6*first*t5*p.weight}
        );
    }

    scalar start = first;
    while (start < toAxis*(1 - SMALL))
    {
        scalar length = min(start, longest);
        if (start + 1.5*length > toAxis)
        {
            length = toAxis - start;
        }
        for (const rulePoint& p : Gauss)
        {
            rule.append
            (
                rulePoint
                {
                    direction*(start + length*p.offset),
                    length*p.weight
                }
            );
        }
        start += length;
    }
}


//- Integral of a kernel over the surface, from forces at the nodes to the nodes
template<class Kernel>
static nodalMatrix integrated(const closedSurface& curve, const Kernel& kernel)
{
    const label n = curve.basis().nPacked();
    const scalar h = curve.basis().spacing();
    const List<rulePoint> Gauss(unitRule(12));
    meridianWaves waves(curve);
    meridianPoint point;
    nodalMatrix result = nodalMatrix::Zero(2*n, 2*n);
    nodalMatrix rows(n, 4);
    DynamicList<rulePoint> rule;

    for (label i = 0; i < n; ++i)
    {
        const scalar theta = waves.theta(i);
        const scalar first = min(h, min(theta, pi - theta));
        rule.clear();
        addPanels(Gauss, -1, theta, first, 4*h, rule);
        addPanels(Gauss, 1, pi - theta, first, 4*h, rule);

        point.r0 = curve.around()(i);
        rows.setZero();
        for (const rulePoint& p : rule)
        {
            const scalar metric = waves.place(i, p.offset, point);
            const kernelValue k =
                p.weight*metric*point.r*kernel(i, point);
            rows.col(0) += k(0, 0)*waves.cosines();
            rows.col(1) += k(1, 0)*waves.cosines();
            rows.col(2) += k(0, 1)*waves.sines();
            rows.col(3) += k(1, 1)*waves.sines();
        }
        result.row(i).head(n) = rows.col(0);
        result.row(n + i).head(n) = rows.col(1);
        result.row(i).tail(n) = rows.col(2);
        result.row(n + i).tail(n) = rows.col(3);
    }
    return waves.nodal(result);
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::ringResponse::singleLayer
(
    const closedSurface& curve,
    const scalar mu
)
{
    // At the angle b around the axis, with w = 1 - cos b: r is (dx, dr + r w)
    // in the node's plane, its product with the force's radial direction is
    // dr - r0 w
    const auto kernel = [&](const label, const meridianPoint& p)
    {
        const scalar product = p.r*p.r0;
        const ringIntegrals J(p.d.squaredNorm(), 2*product);
        const scalar dx = p.d(0);
        const scalar dr = p.d(1);

        kernelValue k;
        k(0, 0) = J.first[0] + sqr(dx)*J.third[0];
        k(0, 1) = dx*(dr*J.third[0] - p.r0*J.third[1]);
        k(1, 0) = dx*(dr*J.third[0] + p.r*J.third[1]);
        k(1, 1) =
            J.first[0] - J.first[1]
          + sqr(dr)*(J.third[0] - J.third[1]) - product*J.third[2];
        return k;
    };
    return integrated(curve, kernel)/(8*pi*mu);
}


Foam::capsule::nodalMatrix Foam::capsule::ringResponse::adjointDoubleLayer
(
    const closedSurface& curve
)
{
    // As above, with r.n = dn + w rn
    const auto kernel = [&](const label i, const meridianPoint& p)
    {
        const scalar product = p.r*p.r0;
        const ringIntegrals J(p.d.squaredNorm(), 2*product);
        const scalar dx = p.d(0);
        const scalar dr = p.d(1);
        const scalar dn = p.d.dot(curve.normal().row(i));
        const scalar rn = p.r*curve.normal()(i, 1);

        // Int (r.n) w^k/R^5
        const auto moment = [&](const label k)
        {
            return dn*J.fifth[k] + rn*J.fifth[k + 1];
        };

        kernelValue k;
        k(0, 0) = sqr(dx)*moment(0);
        k(0, 1) = dx*(dr*moment(0) - p.r0*moment(1));
        k(1, 0) = dx*(dr*moment(0) + p.r*moment(1));
        k(1, 1) =
            sqr(dr)*(moment(0) - moment(1)) - product*moment(2);
        return k;
    };
    return integrated(curve, kernel)*(-3/(4*pi));
}


// ************************************************************************* //
