/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-curve

Description
    Unit tests of curve geometry, bending, free-space responses and the motion
    of points along a drop against exact values. Returns the number of failures.

\*---------------------------------------------------------------------------*/

#include "bendingModel.H"
#include "freeSpaceResponse.H"
#include "membraneMotion.H"
#include "sampleSearch.H"
#include "testing.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::capsule;
using Foam::constant::mathematical::pi;

static nodalVectors ellipse
(
    const curveBasis& basis,
    const scalar a,
    const scalar b
)
{
    nodalVectors x(basis.size(), 2);
    for (label i = 0; i < basis.size(); ++i)
    {
        x.row(i) << 3 + a*std::cos(basis.alpha(i)), b*std::sin(basis.alpha(i));
    }
    return x;
}


//- Geometry of an ellipse; perimeter 4 a E(e) for a = 2, b = 1
static void testEllipse()
{
    const scalar perimeter = 9.688448220547675;
    scalar last = 0;
    for (const label n : {16, 17, 32, 33})
    {
        const curveBasis basis(n);
        const closedSurface curve(basis, ellipse(basis, 2, 1));
        const scalar error = mag(curve.perimeter() - perimeter);
        check("area of an ellipse", curve.volume() - 2*pi, 1e-12);
        check("centroid", curve.centroid()(0) - 3, 1e-12);
        check("extent", curve.extents()(0) - 4, 1e-10);
        check("Taylor deformation", curve.taylorDeformation() - 1.0/3, 1e-10);
        check("curvature at the tip", curve.curvature()(0) - 2, 1e-10);
        for (const scalar angle : {-80.0, 0.0, 30.0, 90.0})
        {
            const scalar a = angle*pi/180;
            nodalVectors x = curve.nodes();
            x.col(0) = std::cos(a)*curve.nodes().col(0)
              - std::sin(a)*curve.nodes().col(1);
            x.col(1) = std::sin(a)*curve.nodes().col(0)
              + std::cos(a)*curve.nodes().col(1);
            check
            (
                "inclination",
                closedSurface(basis, x).inclination() - a, 1e-10
            );
        }
        check
        (
            "inclination of a circle",
            closedSurface(basis, ellipse(basis, 2, 2)).inclination(), 0
        );
        if (n == 33)
        {
            check("perimeter, 33 points", error, 1e-7);
            check("perimeter converges faster than any power", error, 1e-3*last);
        }
        if (n == 17)
        {
            last = error;
        }
    }
}


//- Nearest point: from a point on the normal at a known parameter
static void testFeet()
{
    const curveBasis basis(41);
    const closedSurface curve(basis, ellipse(basis, 2, 1));
    for (const scalar alpha : {0.3, 1.5, 4.0})
    {
        const surfacePoint foot = curve.expand(surfaceParameter(alpha, 0, 0));
        const vector2 n = turned(vector2(foot.first[0])).normalized();
        for (const scalar d : {-0.3, 0.2, 1.0})
        {
            surfaceParameter at(alpha + 0.2, 0, 0);
            const surfacePoint found = curve.foot(foot.x + d*n, at);
            check("foot point", at[0] - alpha, 1e-9);
            check("its position", (found.x - foot.x).norm(), 1e-12);
            check
            (
                "derivative there", (found.first[0] - foot.first[0]).norm(),
                1e-9
            );
        }
    }
}


//- The nearest of some points: against looking at all, for points inside and
//  outside, near and far; the same with a bound just above and just below
static void testSearch()
{
    const curveBasis basis(41);
    const closedSurface curve(basis, ellipse(basis, 2, 1));
    const nodalVectors samples = curve.sampled();
    const sampleSearch search(samples);
    label wrong = 0;
    for (label i = 0; i < 400; ++i)
    {
        const scalar turn = 0.1 + 2.4*i;
        const scalar away = 0.01*i;
        const solvedVector x =
            vector2(3 + away*std::cos(turn), away*std::sin(turn));
        const nodalScalars squares =
            (samples.rowwise() - x).rowwise().squaredNorm();
        const scalar least = squares.minCoeff();
        scalar above = least*(1 + 1e-9);
        scalar below = least*(1 - 1e-9);
        const label found = search.nearest(x);
        wrong +=
            squares(found) != least
         || search.nearest(x, above) == -1
         || mag(above - least) > 1e-12*least
         || search.nearest(x, below) != -1;
    }
    check("points whose nearest sample is not found", wrong, 0);
}


//- Constant tension on a circle: F = -T/R n
static void testTension()
{
    const curveBasis basis(41);
    const closedSurface circle(basis, ellipse(basis, 0.5, 0.5));
    const nodalVectors F = circle.ds(circle.tangent());
    check
    (
        "force on a circle of constant tension",
        (F + 2*circle.normal()).cwiseAbs().maxCoeff(), 1e-10
    );
}


//- Bending: the derivative of the force against central differences, on an
//  ellipse displaced by a smooth wave, away from its initial shape, a flatter
//  one
static void testBending()
{
    const curveBasis basis(41);
    const closedSurface initial(basis, ellipse(basis, 1.8, 1.2));
    const nodalVectors x = ellipse(basis, 2, 1);
    const closedSurface curve(basis, x);
    nodalVectors dx(basis.size(), 2);
    for (label i = 0; i < basis.size(); ++i)
    {
        dx.row(i) = vector2
        (
            std::cos(3*basis.alpha(i)), std::sin(2*basis.alpha(i) + 1)
        );
    }
    const auto model = [&](const char* reference)
    {
        IStringStream is
        (
            std::string("type Helfrich; bendingModulus 0.7; ") + reference
        );
        autoPtr<bendingModel> bending(bendingModel::New(dictionary(is)));
        bending->setReference(initial);
        return bending;
    };
    const auto force = [&](const bendingModel& bending, const scalar step)
    {
        nodalVectors resultant = nodalVectors::Zero(basis.size(), 2);
        bending.addResultant
        (
            closedSurface(basis, x + step*dx), resultant
        );
        return curve.ds(resultant);
    };

    for
    (
        const char* reference :
        {
            "",
            "referenceCurvature initial;",
            "referenceCurvature none;",
            "referenceCurvature 0.6;",
            "referenceCurvature [0 -1 0 0 0 0 0] -0.6;"
        }
    )
    {
        const autoPtr<bendingModel> bending(model(reference));
        const nodalVectors slope =
            (force(*bending, 1e-5) - force(*bending, -1e-5))/2e-5;
        nodalMatrix jacobian =
            nodalMatrix::Zero(2*basis.size(), 2*basis.size());
        bending->addJacobian(curve, jacobian);
        Info<< reference << nl;
        check
        (
            "derivative of the bending force, relative",
            (jacobian*stacked(dx) - stacked(slope)).norm()/slope.norm(),
            1e-6
        );
    }

    // None at the initial shape where that is the reference; elsewhere the
    // part of the initial curvature is the difference, and a curvature that
    // is the same everywhere has no force
    const auto resultant =
        [&](const char* reference, const closedSurface& shape)
    {
        nodalVectors result = nodalVectors::Zero(basis.size(), 2);
        model(reference)->addResultant(shape, result);
        return result;
    };
    const nodalScalars kappa = curve.ds(initial.curvature());
    check
    (
        "bending of the initial shape as reference",
        resultant("", initial).cwiseAbs().maxCoeff(), 1e-9
    );
    check
    (
        "bending without a reference less that from the initial shape",
        (
            resultant("referenceCurvature none;", curve)
          - resultant("referenceCurvature initial;", curve)
          - scaled(0.7*kappa, curve.normal())
        ).cwiseAbs().maxCoeff(), 1e-9
    );
    check
    (
        "bending by a uniform reference less that without one",
        (
            resultant("referenceCurvature 0.6;", curve)
          - resultant("referenceCurvature none;", curve)
        ).cwiseAbs().maxCoeff(), 1e-9
    );
    check
    (
        "bending without a reference, at least 0.1",
        0.1/resultant("referenceCurvature none;", initial)
           .cwiseAbs().maxCoeff(), 1
    );
}


//- A normal force cos(m theta) on a circle of radius R in one viscosity
//  moves it by R m/(4 mu (m^2 - 1)) cos(m theta) n (plus a part along t)
static void testResponse()
{
    const curveBasis basis(41);
    const closedSurface circle(basis, ellipse(basis, 2, 2));
    const nodalMatrix S = freeSpaceResponse::singleLayer(circle, 0.5);
    const nodalMatrix K = freeSpaceResponse::adjointDoubleLayer(circle);
    for (const label m : {2, 3, 7})
    {
        nodalScalars c(basis.size());
        for (label i = 0; i < basis.size(); ++i)
        {
            c(i) = std::cos(m*basis.alpha(i));
        }
        const nodalVectors f = scaled(c, circle.normal());
        const nodalScalars fs = Eigen::Map<const nodalScalars>(f.data(), f.size());
        const nodalScalars us = S*fs;
        const nodalVectors u =
            Eigen::Map<const nodalVectors>(us.data(), f.rows(), 2);
        check
        (
            "free-space velocity of a mode",
            (
                dot(u, circle.normal()) - 2*m/(4*0.5*(m*m - 1.0))*c
            ).cwiseAbs().maxCoeff(), 1e-10
        );
    }

    // A uniform pressure has no traction outside: K n = n/2
    {
        const nodalVectors& n = circle.normal();
        const nodalScalars ns = Eigen::Map<const nodalScalars>(n.data(), n.size());
        check
        (
            "free-space traction of a uniform pressure",
            (K*ns - 0.5*ns).cwiseAbs().maxCoeff(), 1e-10
        );
    }
}


//- Integral over the parameter
static void testIntegral()
{
    for (const label n : {16, 17})
    {
        const curveBasis nodes(n);
        nodalScalars f(n);
        nodalScalars exact(n);
        for (label i = 0; i < n; ++i)
        {
            const scalar a = nodes.alpha(i);
            f(i) = 3 + std::cos(2*a) + std::sin(5*a);
            exact(i) = 0.5*std::sin(2*a) - 0.2*std::cos(5*a);
        }
        check
        (
            "integral over the parameter",
            (nodes.integrated(f) - exact).cwiseAbs().maxCoeff(), 1e-13
        );
    }
}


//- Points of a drop move with it, and stand still as it turns
static void testCarried()
{
    const curveBasis basis(41);
    const closedSurface body(basis, ellipse(basis, 2, 1));
    const closedSurface circle(basis, ellipse(basis, 2, 2));
    const nodalScalars even = nodalScalars::Ones(basis.size());
    nodalVectors U(basis.size(), 2);
    U.col(0).setConstant(0.7);
    U.col(1).setConstant(-0.3);
    check
    (
        "points of a drop carried",
        membraneMotion::excess(body, even, U, 1).cwiseAbs().maxCoeff(),
        1e-12
    );
    U.col(0) = -circle.nodes().col(1);
    U.col(1) = circle.nodes().col(0).array() - 3;
    check
    (
        "points of a drop turning",
        (
            membraneMotion::excess(circle, even, U, 1).array() + 2
        ).abs().maxCoeff(),
        1e-12
    );

    // In a flow that stretches it their stretch stays uniform
    U.col(0) = body.nodes().col(0).array() - 3;
    U.col(1) = -body.nodes().col(1);
    const nodalVectors V =
        U
      + scaled
        (
            membraneMotion::excess(body, body.metric(), U, 1),
            body.tangent()
        );
    const nodalScalars rate =
        dot(body.ds(V), body.tangent());
    check
    (
        "stretch of a drop stays uniform",
        rate.maxCoeff() - rate.minCoeff(), 2e-3
    );
}


//- Round an ellipse that flow goes along, uneven points become even and
//  stand still; meanwhile the fluid goes round it twice
static void testEven()
{
    const curveBasis basis(41);
    const nodalScalars even = nodalScalars::Ones(basis.size());
    nodalVectors x = ellipse(basis, 1.4, 1);
    nodalScalars pace;
    for (label step = 0; step < 300; ++step)
    {
        const closedSurface now(basis, x);
        nodalVectors U(basis.size(), 2);
        U.col(0) = -1.4*x.col(1);
        U.col(1) = ((x.col(0).array() - 3)/1.4).matrix();
        const nodalScalars w = membraneMotion::excess(now, even, U, 5);
        pace = dot(U, now.tangent()) + w;
        x += 0.05*(U + scaled(w, now.tangent()));
        // Only the motion along the ellipse
        for (label i = 0; i < basis.size(); ++i)
        {
            const vector2 d(x(i, 0) - 3, x(i, 1));
            const scalar off = std::hypot(d(0)/1.4, d(1));
            x.row(i) << 3 + d(0)/off, d(1)/off;
        }
    }
    const nodalScalars g = closedSurface(basis, x).metric();
    check
    (
        "points become even",
        g.maxCoeff()/g.minCoeff() - 1, 1e-4
    );
    check("points stand still", pace.cwiseAbs().maxCoeff(), 1e-3);
}


int main()
{
    testEllipse();
    testFeet();
    testSearch();
    testTension();
    testBending();
    testResponse();
    testIntegral();
    testCarried();
    testEven();

    return nFailed();
}
