/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-response

Description
    Unit tests of the response of an unbounded Stokes fluid to a force on a
    closed surface: surfaces of revolution by 20, 40 and 80 nodes of the
    meridian, against exact solutions of the sphere and of spheroids, identities
    that hold for any shape and themselves with 160 nodes; and plane circles.
    Returns the number of failures.

\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "freeSpaceResponse.H"
#include "ringIntegrals.H"
#include "sphereSolution.H"
#include "clockTime.H"
#include "IOstreams.H"
#include <map>

using namespace Foam;
using namespace Foam::capsule;
using Foam::constant::mathematical::pi;

//- Integrals around rings against the trapezoidal rule of many points
static void testIntegrals()
{
    scalar error = 0;
    for (const scalar d2 : {1e-3, 0.02, 0.5, 1.999, 2.001, 40.0, 1e4})
    {
        const label m = 4000;
        const ringIntegrals J(d2, 1);
        scalar first[2] = {}, third[3] = {}, fifth[4] = {};
        for (label i = 0; i < m; ++i)
        {
            const scalar w = 1 - std::cos(2*pi*(i + 0.5)/m);
            const scalar R = std::sqrt(d2 + w);
            for (label k = 0; k < 4; ++k)
            {
                const scalar f = 2*pi/m*std::pow(w, scalar(k));
                if (k < 2) first[k] += f/R;
                if (k < 3) third[k] += f/pow3(R);
                fifth[k] += f/pow5(R);
            }
        }
        for (label k = 0; k < 4; ++k)
        {
            if (k < 2) error = max(error, mag(J.first[k]/first[k] - 1));
            if (k < 3) error = max(error, mag(J.third[k]/third[k] - 1));
            error = max(error, mag(J.fifth[k]/fifth[k] - 1));
        }
    }
    check("integrals around rings, relative", error, 1e-13);
}


//- Sphere: modes of the force against the exact velocity and tractions
static void testSphere(const label n)
{
    const scalar a = 1.3;
    const axisymmetricBasis basis(2*n, axis);
    const closedSurface sphere(basis, nodes(basis, spheroid(a, a)));
    const nodalMatrix S = freeSpaceResponse::singleLayer(sphere, mu);
    const nodalMatrix K = freeSpaceResponse::adjointDoubleLayer(sphere);

    scalar velocity = 0, inside = 0, outside = 0;
    for (label l = 1; l <= 5; ++l)
    {
        for (const vector2& force : {vector2(1, 0), vector2(0, 1)})
        {
            const sphereSolution exact(l, force, mu, a);
            const auto mode = [&](const vector2& v)
            {
                nodalVectors result(2*n, 2);
                for (label j = 0; j < 2*n; ++j)
                {
                    const scalar theta = basis.alpha(j) + basis.start();
                    result.row(j) =
                        v(0)*Legendre(l, theta)*sphere.normal().row(j)
                      + v(1)*LegendreSlope(l, theta)*sphere.tangent().row(j);
                }
                return basis.pack(result);
            };
            const nodalScalars f = mode(force);
            const nodalScalars mean = K*f;
            velocity = max(velocity, largest(S*f - mode(exact.velocity())));
            inside =
                max(inside, largest(mean + 0.5*f - mode(exact.inside())));
            outside =
                max(outside, largest(mean - 0.5*f - mode(exact.outside())));
        }
    }
    check("sphere, velocity of modes 1 to 5" + points(n), velocity, 2e-9);
    check("sphere, traction inside" + points(n), inside, 1e-10);
    check("sphere, traction outside" + points(n), outside, 1e-10);
}


//- A spheroid of semi-axis a along the axis, b across, under the force by which
//  it translates
static void testTranslation
(
    const label n,
    const scalar a,
    const scalar b,
    const scalar bound
)
{
    const axisymmetricBasis basis(2*n, axis);
    const closedSurface surface(basis, nodes(basis, spheroid(a, b)));

    const scalar speed = translationSpeed(a, b, mu);

    nodalVectors force = nodalVectors::Zero(2*n, 2);
    nodalVectors motion = nodalVectors::Zero(2*n, 2);
    for (label j = 0; j < 2*n; ++j)
    {
        const scalar theta = basis.alpha(j) + basis.start();
        force(j, 0) =
            1/std::hypot(std::cos(theta)/a, std::sin(theta)/b);
        motion(j, 0) = speed;
    }
    const nodalScalars f = basis.pack(force);
    const nodalScalars u = freeSpaceResponse::singleLayer(surface, mu)*f;
    const nodalScalars inside =
        freeSpaceResponse::adjointDoubleLayer(surface)*f + 0.5*f;

    const std::string shape =
        "spheroid " + std::to_string(a/b).substr(0, 4) + ", ";
    check
    (
        shape + "translation" + points(n),
        largest(u - basis.pack(motion))/speed, bound
    );
    check(shape + "fluid at rest inside" + points(n), largest(inside), bound);
}


//- What holds on any shape
static void testIdentities
(
    const std::string& name,
    const meridian& shape,
    const label n,
    const scalar bound
)
{
    const axisymmetricBasis basis(2*n, axis);
    const closedSurface surface(basis, nodes(basis, shape));
    const nodalMatrix S = freeSpaceResponse::singleLayer(surface, mu);
    const nodalMatrix K = freeSpaceResponse::adjointDoubleLayer(surface);

    const nodalScalars normal = basis.pack(surface.normal());
    check
    (
        name + ", uniform pressure moves nothing" + points(n),
        largest(S*normal)*mu, bound
    );
    check
    (
        name + ", traction of uniform pressure" + points(n),
        largest(K*normal - 0.5*normal), bound
    );

    const nodalScalars weights =
        basis.weights().cwiseProduct(surface.areaElement()).head(n);
    nodalScalars both(2*n);
    both << weights, weights;
    const nodalMatrix waves = longWaves(n);
    const nodalMatrix work = waves.transpose()*both.asDiagonal()*S*waves;
    check
    (
        name + ", symmetry of the work, relative" + points(n),
        (work - work.transpose()).cwiseAbs().maxCoeff()
       /work.cwiseAbs().maxCoeff(), bound
    );

    const nodalScalars f = basis.pack(smoothForce(surface));
    const nodalScalars inside = K*f + 0.5*f;
    check
    (
        name + ", no resultant inside, relative" + points(n),
        weights.dot(inside.head(n))/weights.dot(f.head(n)), bound
    );
}


//- A smooth force against 160 nodes
static void testConvergence
(
    const std::string& name,
    const meridian& shape,
    const std::map<label, scalar>& bounds
)
{
    const auto responses = [](const closedSurface& surface)
    {
        const nodalScalars f = surface.basis().pack(smoothForce(surface));
        nodalMatrix result(f.size(), 2);
        result.col(0) = freeSpaceResponse::singleLayer(surface, mu)*f;
        result.col(1) = freeSpaceResponse::adjointDoubleLayer(surface)*f;
        return result;
    };
    const axisymmetricBasis many(320, axis);
    const nodalMatrix fine =
        responses(closedSurface(many, nodes(many, shape)));

    for (const auto& bound : bounds)
    {
        const label n = bound.first;
        const axisymmetricBasis basis(2*n, axis);
        const nodalMatrix coarse =
            responses(closedSurface(basis, nodes(basis, shape)));

        List<surfaceParameter> at(2*n);
        forAll(at, j)
        {
            at[j][0] = basis.alpha(j) + basis.start() - many.start();
        }
        const nodalMatrix toNodes = many.functions(at)*many.analysis();
        const auto error = [&](const label i)
        {
            const nodalScalars exact =
                basis.pack(toNodes*many.unpack(fine.col(i)));
            return largest(coarse.col(i) - exact)/largest(exact);
        };
        check
        (
            name + ", velocity against 160 nodes, relative" + points(n),
            error(0), bound.second
        );
        check
        (
            name + ", traction against 160 nodes, relative" + points(n),
            error(1), bound.second
        );
    }
}


//- A force cos(m theta) along the normal or the tangent of a plane circle
static void testCircle()
{
    const label n = 41;
    const scalar R = 2;
    const curveBasis basis(n);
    nodalVectors x(n, 2);
    for (label i = 0; i < n; ++i)
    {
        const scalar alpha = basis.alpha(i);
        x.row(i) << 3 + R*std::cos(alpha), R*std::sin(alpha);
    }
    const closedSurface circle(basis, x);
    const nodalMatrix S = freeSpaceResponse::singleLayer(circle, mu);
    const nodalMatrix K = freeSpaceResponse::adjointDoubleLayer(circle);

    scalar velocity = 0;
    for (const label m : {2, 3, 7})
    {
        nodalScalars c(n), s(n);
        for (label i = 0; i < n; ++i)
        {
            c(i) = std::cos(m*basis.alpha(i));
            s(i) = std::sin(m*basis.alpha(i));
        }
        const scalar scale = R/(4*mu*(m*m - 1.0));
        const nodalVectors exact =
            scaled(scale*m*c, circle.normal())
          - scaled(scale*s, circle.tangent());
        const nodalScalars f = stacked(scaled(c, circle.normal()));
        velocity = max(velocity, largest(S*f - stacked(exact)));
    }
    check("circle in the plane, velocity of modes", velocity, 1e-12);

    const nodalScalars normal = stacked(circle.normal());
    check
    (
        "circle in the plane, uniform pressure moves nothing",
        largest(S*normal), 1e-12
    );
    check
    (
        "circle in the plane, its traction",
        largest(K*normal - 0.5*normal), 1e-12
    );
}


//- Seconds for both matrices
static void time(const label n)
{
    const axisymmetricBasis basis(2*n, axis);
    const closedSurface surface(basis, nodes(basis, biconcave));
    const clockTime clock;
    for (label i = 0; i < 10; ++i)
    {
        freeSpaceResponse::singleLayer(surface, mu);
    }
    const scalar single = clock.elapsedTime()/10;
    for (label i = 0; i < 10; ++i)
    {
        freeSpaceResponse::adjointDoubleLayer(surface);
    }
    Info<< n << " nodes: single layer " << 1000*single
        << " ms, adjoint double layer "
        << 1000*(clock.elapsedTime()/10 - single) << " ms" << endl;
}


int main()
{
    testIntegrals();
    for (const label n : {20, 40, 80})
    {
        testSphere(n);
    }
    for (const label n : {20, 40, 80})
    {
        testTranslation(n, 2, 1, n == 20 ? 1e-6 : 1e-9);
        testTranslation(n, 0.5, 1.25, n == 20 ? 5e-6 : 1e-9);
        testIdentities("spheroid", spheroid(2, 1), n, n == 20 ? 1e-6 : 1e-9);
    }
    testIdentities("biconcave", biconcave, 20, 2e-4);
    testIdentities("biconcave", biconcave, 40, 5e-8);
    testIdentities("biconcave", biconcave, 80, 1e-9);
    testConvergence
    (
        "spheroid", spheroid(2, 1), {{20, 1e-8}, {40, 1e-9}, {80, 1e-9}}
    );
    testConvergence
    (
        "biconcave", biconcave, {{20, 1e-6}, {40, 5e-9}, {80, 1e-9}}
    );
    testCircle();

    time(60);
    time(100);
    return nFailed();
}


// ************************************************************************* //
