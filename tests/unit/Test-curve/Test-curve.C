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

#include "bendingTests.H"
#include "dropTests.H"
#include "responseTests.H"
#include "sampleSearch.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::capsule;
using Foam::constant::mathematical::pi;

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
