/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-harmonics

Description
    Unit tests of spherical harmonics, of grids on the sphere and of Gauss's
    rule: against identities of the functions, differences along great circles,
    also at the poles, and the curvature of an ellipsoid. Prints run times.
    Returns the number of failures.

\*---------------------------------------------------------------------------*/

#include "gridTests.H"
#include "GaussRule.H"
#include "clockTime.H"

using namespace Foam;
using namespace Foam::capsule;

static void testRule()
{
    scalar integral = 0, order = 0;
    for (const label n : {1, 2, 5, 12, 17, 33, 64})
    {
        const GaussRule rule(n);
        for (label k = 0; k < 2*n; ++k)
        {
            scalar sum = k % 2 == 0 ? -2.0/(k + 1) : 0;
            for (label i = 0; i < n; ++i)
            {
                sum += rule.weight(i)*std::pow(rule.node(i), scalar(k));
                order = max(order, i ? rule.node(i - 1) - rule.node(i) : -1);
            }
            integral = max(integral, mag(sum));
        }
    }
    check("Gauss rule, powers", integral, 5e-15);
    check("Gauss rule, rising nodes", max(order, scalar(0)), 0);
}


static void testOrder()
{
    const label p = 12;
    const sphericalHarmonics all(p), few(7);
    label wrong = 0;
    scalar difference = 0;
    for (label l = 0; l <= p; ++l)
    {
        for (label i = l*l; i < sphericalHarmonics::size(l); ++i)
        {
            wrong += sphericalHarmonics::degreeOf(i) != l;
        }
    }
    for (const vector& y : directions())
    {
        const nodalScalars Y = all.values(y);
        difference =
            max(difference, largest(Y.head(few.size()) - few.values(y)));

        // First of each degree, and all of the first two
        const scalar z = y.z();
        nodalScalars exact(9);
        exact
            << 1, std::sqrt(3.0)*z, std::sqrt(3.0)*y.x(), std::sqrt(3.0)*y.y(),
            std::sqrt(5.0)*(1.5*sqr(z) - 0.5),
            std::sqrt(15.0)*z*y.x(), std::sqrt(15.0)*z*y.y(),
            std::sqrt(3.75)*(sqr(y.x()) - sqr(y.y())),
            std::sqrt(15.0)*y.x()*y.y();
        difference = max(difference, largest(Y.head(9) - exact));
    }
    check("functions not of their degree", wrong, 0);
    check("functions to degree 2, and of fewer degrees", difference, 2e-15);
}


static void testAddition()
{
    const sphericalHarmonics harmonics(24);
    const List<vector> points(directions());
    scalar error = 0;
    for (const vector& a : points)
    {
        for (const vector& b : points)
        {
            const nodalScalars product =
                harmonics.values(a).cwiseProduct(harmonics.values(b));

            // Legendre polynomials
            const scalar z = a & b;
            scalar before = 0;
            scalar P = 1;
            for (label l = 0; l <= harmonics.degree(); ++l)
            {
                const scalar sum = product.segment(l*l, 2*l + 1).sum();
                error = max(error, mag(sum/(2*l + 1) - P));
                const scalar next = ((2*l + 1)*z*P - l*before)/(l + 1);
                before = P;
                P = next;
            }
        }
    }
    check("addition theorem, degrees to 24", error, 1e-12);
}


//- Along a great circle, a geodesic, the second derivative is the covariant one
static void testDerivatives()
{
    const sphericalHarmonics harmonics(12);
    nodalScalars degrees(harmonics.size());
    for (label i = 0; i < harmonics.size(); ++i)
    {
        degrees(i) = sphericalHarmonics::degreeOf(i);
    }
    const nodalScalars eigenvalues =
        (degrees.array()*(degrees.array() + 1)).matrix();

    const List<vector> points(directions());
    scalar frame = 0, value = 0, Laplacian = 0;
    scalar first[2] = {}, second[2] = {};
    forAll(points, i)
    {
        const vector& y = points[i];
        vector e1, e2;
        turnedTangents(y, 0.7*i, e1, e2);
        frame = max(frame, mag((e1 ^ e2) - y));
        sphericalHarmonics::tangents(y, e1, e2);
        frame = max(frame, mag((e1 ^ e2) - y) + mag(e1 & e2) + mag(e1 & y));
        turnedTangents(y, 0.7*i, e1, e2);

        const auto parts = harmonics.expansion(y, e1, e2);
        const auto along = [&](const vector& e)
        {
            return [&harmonics, y, e](const scalar angle)
            {
                return harmonics.values(std::cos(angle)*y + std::sin(angle)*e);
            };
        };
        const scalar h = 0.003;
        const vector e12 = (e1 + e2)/std::sqrt(2.0);
        const nodalScalars d11 = curvature(along(e1), h);
        const nodalScalars d22 = curvature(along(e2), h);
        const nodalScalars d12 = curvature(along(e12), h) - 0.5*(d11 + d22);

        const label isPole = i < 2;
        value = max(value, largest(parts.col(0) - harmonics.values(y)));
        scalar& error1 = first[isPole];
        error1 = max(error1, largest(parts.col(1) - slope(along(e1), h)));
        error1 = max(error1, largest(parts.col(2) - slope(along(e2), h)));
        scalar& error2 = second[isPole];
        error2 = max(error2, largest(parts.col(3) - d11));
        error2 = max(error2, largest(parts.col(4) - d12));
        error2 = max(error2, largest(parts.col(5) - d22));
        Laplacian = max
        (
            Laplacian,
            largest
            (
                parts.col(3) + parts.col(5)
              + eigenvalues.cwiseProduct(parts.col(0))
            )
        );
    }
    check("tangents", frame, 1e-15);
    check("values of the expansion", value, 1e-14);
    check("first derivatives", first[0], 1e-8);
    check("first derivatives at the poles", first[1], 1e-8);
    check("second derivatives", second[0], 3e-8);
    check("second derivatives at the poles", second[1], 3e-8);
    check("surface Laplacian", Laplacian, 1e-11);
}


//- Fields of all functions, and of fewer degrees
static void testExpand()
{
    const sphericalHarmonics harmonics(20);
    scalar error = 0;
    for (const label p : {20, 9, 0})
    {
        const label n = sphericalHarmonics::size(p);
        const nodalVectors field = nodalVectors::Random(n, 3);
        for (const vector& y : directions())
        {
            vector e1, e2;
            turnedTangents(y, 1, e1, e2);
            const auto parts = harmonics.expansion(y, e1, e2);
            sphericalHarmonics::fieldExpansion result;
            harmonics.expand(y, e1, e2, field, result);
            error = max
            (
                error,
                largest(result - parts.topRows(n).transpose()*field)
               /largest(parts)
            );
        }
    }
    check("fields from coefficients, relative", error, 1e-13);
}


//- Microseconds a point
static void time()
{
    const sphericalHarmonics fine(24), harmonics(20);
    const nodalVectors field = nodalVectors::Random(harmonics.size(), 3);
    const label n = 20000;
    scalar sum = 0;
    const vector y(0.36, 0.48, 0.8);
    vector e1, e2;
    sphericalHarmonics::tangents(y, e1, e2);
    sphericalHarmonics::fieldExpansion parts;

    clockTime clock;
    for (label i = 0; i < n; ++i)
    {
        sum += fine.values(y)(i % 9);
    }
    const scalar values = clock.timeIncrement();
    for (label i = 0; i < n; ++i)
    {
        sum += harmonics.expansion(y, e1, e2)(i % 9, 5);
    }
    const scalar expansion = clock.timeIncrement();
    for (label i = 0; i < n; ++i)
    {
        harmonics.expand(y, e1, e2, field, parts);
        sum += parts(i % 6, 2);
    }
    const scalar expand = clock.timeIncrement();
    Info<< "microseconds a point: values, degree 24, " << 1e6*values/n
        << "; expansion, degree 20, " << 1e6*expansion/n
        << "; expand, degree 20, " << 1e6*expand/n
        << " (sum " << sum << ")" << endl;
}


int main()
{
    testRule();
    testOrder();
    testAddition();
    testDerivatives();
    testExpand();
    testGrid();
    testGridDerivatives();
    testEllipsoid();
    time();
    return nFailed();
}


// ************************************************************************* //
