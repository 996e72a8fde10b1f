/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-surfaceResponse

Description
    Unit tests of the response of an unbounded Stokes fluid to a force on a
    closed surface in space: against exact solutions of the sphere and of a
    spheroid, the response of surfaces of revolution, itself with harmonics of
    a higher degree, and what holds on any shape. Returns the number of
    failures.

\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "sphereSolution.H"
#include "spaceSurface.H"
#include "surfaceResponse.H"
#include "ringResponse.H"
#include "clockTime.H"
#include <map>

using namespace Foam;
using namespace Foam::capsule;
using Foam::constant::mathematical::pi;

static const spaceShape longEllipsoid = ellipsoid(vector(2, 1, 1));
static const spaceShape unequalEllipsoid = ellipsoid(vector(0.8, 1.6, 1.1));

static std::string degree(const label p)
{
    return ", p = " + std::to_string(p);
}

static nodalMatrix singleLayer(const spaceSurface& surface)
{
    return surfaceResponse::singleLayer(surface.harmonics(), surface.X(), mu);
}

static nodalMatrix adjointDoubleLayer(const spaceSurface& surface)
{
    return
        surfaceResponse::adjointDoubleLayer(surface.harmonics(), surface.X());
}

static scalar relativeError(const nodalScalars& v, const nodalScalars& exact)
{
    return (v - exact).norm()/exact.norm();
}


//- Sphere: all modes of the force against the exact velocity and tractions
static void testSphere(const label p, const scalar bound)
{
    const scalar a = 1.3;
    const vector centre(0.5, -2, 1);
    const spaceSurface sphere
    (
        p, [&](const vector& y) { return centre + a*y; }
    );
    const nodalMatrix S = singleLayer(sphere);
    const nodalMatrix K = adjointDoubleLayer(sphere);

    const sphericalGrid& grid = sphere.grid();
    scalar velocity = 0, inside = 0, outside = 0;
    for (label i = 1; i < sphericalHarmonics::size(4); ++i)
    {
        // Y n, grad_S Y and n x grad_S Y
        vectorField radial(grid.size()), gradient(grid.size());
        forAll(radial, j)
        {
            const vector& n = grid.nodes()[j];
            const vector east = normalised(vector(0, 0, 1) ^ n);
            radial[j] = grid.values()(j, i)*n;
            gradient[j] =
                grid.derivative(0)(j, i)*(east ^ n)
              + grid.derivative(1)(j, i)*east;
        }
        const nodalScalars R = sphere.packed(radial);
        const nodalScalars G = sphere.packed(gradient);
        const nodalScalars T = sphere.packed(grid.nodes() ^ gradient);

        const auto judge = [&]
        (
            const nodalScalars& f,
            const nodalScalars& u,
            const nodalScalars& in,
            const nodalScalars& out
        )
        {
            const scalar size = f.norm();
            const nodalScalars mean = K*f;
            velocity = max(velocity, (S*f - u).norm()*mu/size);
            inside = max(inside, (mean + 0.5*f - in).norm()/size);
            outside = max(outside, (mean - 0.5*f - out).norm()/size);
        };
        const label l = sphericalHarmonics::degreeOf(i);
        for (const vector2& force : {vector2(1, 0), vector2(0, 1)})
        {
            const sphereSolution exact(l, force, mu, a);
            const auto mode = [&](const vector2& v)
            {
                return nodalScalars(v(0)*R + v(1)*G);
            };
            judge
            (
                mode(force), mode(exact.velocity()),
                mode(exact.inside()), mode(exact.outside())
            );
        }

        // Toroidal: the velocity goes as r^l inside, r^-(l + 1) outside
        const scalar share = 1.0/(2*l + 1);
        judge
        (
            T, a*share/mu*T, (l - 1)*share*T, -(l + 2)*share*T
        );
    }
    check("sphere, velocity of modes 1 to 4" + degree(p), velocity, bound);
    check("sphere, traction inside" + degree(p), inside, bound);
    check("sphere, traction outside" + degree(p), outside, bound);

    // Stokes's drag
    const vector force(0.3, -1, 0.7);
    const vector U = 4*pi*sqr(a)*force/(6*pi*mu*a);
    check
    (
        "sphere, drag" + degree(p),
        relativeError(S*sphere.uniform(force), sphere.uniform(U)), bound
    );
}


//- A spheroid 2:1:1 under the force by which it translates along its axis
static void testTranslation
(
    const label p,
    const scalar bound,
    const scalar tractionBound
)
{
    const spaceSurface surface(p, longEllipsoid);
    vectorField force(surface.nodes().size());
    forAll(force, i)
    {
        force[i] =
            vector((surface.nodes()[i] & surface.normal()[i]), 0, 0);
    }
    const nodalScalars f = surface.packed(force);
    const nodalScalars motion =
        surface.uniform(vector(translationSpeed(2, 1, mu), 0, 0));
    check
    (
        "spheroid, translation" + degree(p),
        relativeError(singleLayer(surface)*f, motion), bound
    );
    const nodalScalars inside = adjointDoubleLayer(surface)*f + 0.5*f;
    check
    (
        "spheroid, fluid at rest inside" + degree(p),
        inside.norm()/f.norm(), tractionBound
    );
}


//- Force of long waves, a function of the position
static nodalScalars smoothForce(const spaceSurface& surface)
{
    vectorField force(surface.nodes().size());
    forAll(force, i)
    {
        const vector& x = surface.nodes()[i];
        force[i] = vector
        (
            1 + std::sin(2*x.x()) + 0.5*x.y()*x.z(),
            x.y()*std::cos(x.x()) - 0.4*x.z(),
            0.7 + x.z()*std::cos(x.x() + x.y())
        );
    }
    return surface.packed(force);
}


//- What holds on any shape, by construction or not
static void testIdentities
(
    const std::string& name,
    const spaceShape& shape,
    const label p,
    const scalar bound
)
{
    const spaceSurface surface(p, shape);
    const nodalMatrix S = singleLayer(surface);
    const nodalMatrix K = adjointDoubleLayer(surface);
    const nodalMatrix product = surface.product();
    const nodalMatrix work = product*S;
    const nodalScalars n = surface.packed(surface.normal());

    check
    (
        name + ", uniform pressure moves nothing" + degree(p),
        (S*n).norm()*mu, 1e-13
    );
    check
    (
        name + ", traction of uniform pressure" + degree(p),
        relativeError(K*n, 0.5*n), 1e-13
    );
    check
    (
        name + ", no flux" + degree(p),
        (work.transpose()*n).norm()*mu, 1e-12
    );
    check
    (
        name + ", symmetry of the work" + degree(p),
        (work - work.transpose()).norm()/work.norm(), 1e-13
    );
    const nodalScalars eigenvalues =
        Eigen::SelfAdjointEigenSolver<nodalMatrix>(work).eigenvalues()
       /work.norm();
    check
    (
        name + ", one force does no work" + degree(p), eigenvalues(0), 1e-13
    );
    // The shortest waves do the least, about 1/p of that of translation
    check
    (
        name + ", all others do, least part inverted" + degree(p),
        eigenvalues(1) > 0 ? 1/eigenvalues(1) : GREAT, 100*p
    );

    const nodalScalars f = smoothForce(surface);
    const nodalScalars inside = K*f + 0.5*f;
    scalar resultant = 0;
    for (label a = 0; a < 3; ++a)
    {
        vector e = Zero;
        e[a] = 1;
        const nodalScalars weights = product*surface.uniform(e);
        resultant = max(resultant, mag(weights.dot(inside)));
    }
    check
    (
        name + ", no resultant inside, relative" + degree(p),
        resultant/(product*f).norm(), bound
    );
}


//- The response turns with the surface, and has the right dimensions
static void testInvariance(const label p)
{
    const spaceSurface surface(p, unequalEllipsoid);
    const nodalMatrix S = singleLayer(surface);
    const nodalMatrix K = adjointDoubleLayer(surface);

    // The same points in another frame
    const tensor Q = rotation();
    const spaceSurface other
    (
        p, [&](const vector& y) { return Q & unequalEllipsoid(y); }
    );
    const label n = surface.size();
    nodalMatrix turn = nodalMatrix::Zero(3*n, 3*n);
    for (label a = 0; a < 3; ++a)
    {
        for (label b = 0; b < 3; ++b)
        {
            turn.block(a*n, b*n, n, n).diagonal().setConstant(Q(a, b));
        }
    }
    check
    (
        "turned ellipsoid, velocity",
        (singleLayer(other)*turn - turn*S).norm()/S.norm(), 1e-12
    );
    check
    (
        "turned ellipsoid, traction",
        (adjointDoubleLayer(other)*turn - turn*K).norm()/K.norm(), 1e-12
    );

    // The same shape, with other points at the poles of the parameter sphere
    const spaceSurface moved
    (
        p, [&](const vector& y) { return unequalEllipsoid(Q & y); }
    );
    const nodalScalars u = S*smoothForce(surface);
    const nodalScalars tau = K*smoothForce(surface);
    const nodalScalars movedU = singleLayer(moved)*smoothForce(moved);
    const nodalScalars movedTau =
        adjointDoubleLayer(moved)*smoothForce(moved);
    scalar velocity = 0, traction = 0;
    for (const vector& y : surface.grid().nodes())
    {
        velocity =
            max(velocity, mag(moved.at(movedU, y) - surface.at(u, Q & y)));
        traction =
            max(traction, mag(moved.at(movedTau, y) - surface.at(tau, Q & y)));
    }
    check("moved parameters, velocity" + degree(p), velocity*mu, 2e-4);
    check("moved parameters, traction" + degree(p), traction, 5e-3);

    const nodalVectors twice = 2*surface.X();
    check
    (
        "size and viscosity, velocity",
        (
            surfaceResponse::singleLayer(surface.harmonics(), twice, 3*mu)
          - 2*S/3
        ).norm()/S.norm(), 1e-12
    );
    check
    (
        "size, traction",
        (
            surfaceResponse::adjointDoubleLayer(surface.harmonics(), twice) - K
        ).norm()/K.norm(), 1e-12
    );
}


//- A smooth force against harmonics of degree 16
static void testConvergence
(
    const std::string& name,
    const spaceShape& shape,
    const std::map<label, scalar>& bounds
)
{
    const spaceSurface fine(16, shape);
    const nodalScalars fineU = singleLayer(fine)*smoothForce(fine);
    const nodalScalars fineTau = adjointDoubleLayer(fine)*smoothForce(fine);
    for (const auto& bound : bounds)
    {
        const spaceSurface surface(bound.first, shape);
        const auto error = [&](const nodalScalars& v, const nodalScalars& exact)
        {
            scalar largest = 0, size = 0;
            for (const vector& y : surface.grid().nodes())
            {
                const vector correct = fine.at(exact, y);
                largest = max(largest, mag(surface.at(v, y) - correct));
                size = max(size, mag(correct));
            }
            return largest/size;
        };
        const nodalScalars f = smoothForce(surface);
        check
        (
            name + ", velocity against p = 16" + degree(bound.first),
            error(singleLayer(surface)*f, fineU), bound.second
        );
        check
        (
            name + ", traction against p = 16" + degree(bound.first),
            error(adjointDoubleLayer(surface)*f, fineTau), 30*bound.second
        );
    }
}


//- A biconcave cell under an axisymmetric force, against the response of a
//  surface of revolution
static void testRevolution(const label p, const scalar bound)
{
    const label n = 40;
    const axisymmetricBasis basis(2*n, axis);
    const closedSurface curve(basis, nodes(basis, biconcave));
    const nodalScalars ring = basis.pack(smoothForce(curve));
    const nodalScalars ringU = ringResponse::singleLayer(curve, mu)*ring;
    const nodalScalars ringTau = ringResponse::adjointDoubleLayer(curve)*ring;

    const spaceSurface surface(p, biconcaveCell);
    vectorField force(surface.nodes().size());
    forAll(force, i)
    {
        // As smoothForce of a closed curve
        const vector& x = surface.nodes()[i];
        force[i] = vector
        (
            1 + std::sin(2*x.x()),
            x.y()*std::cos(x.x()),
            x.z()*std::cos(x.x())
        );
    }
    const nodalScalars f = surface.packed(force);
    const auto error = [&](const nodalScalars& v, const nodalScalars& exact)
    {
        scalar result = 0;
        for (label j = 0; j < n; ++j)
        {
            const scalar theta = basis.alpha(j) + basis.start();
            const vector y(std::cos(theta), std::sin(theta), 0);
            const vector difference =
                surface.at(v, y) - vector(exact(j), exact(n + j), 0);
            result = max(result, mag(difference));
        }
        return result/largest(exact);
    };
    check
    (
        "biconcave, velocity against rings" + degree(p),
        error(singleLayer(surface)*f, ringU), bound
    );
    check
    (
        "biconcave, traction against rings" + degree(p),
        error(adjointDoubleLayer(surface)*f, ringTau), 30*bound
    );
}


static void time(const label p)
{
    const spaceSurface surface(p, biconcaveCell);
    const clockTime clock;
    singleLayer(surface);
    const scalar single = clock.elapsedTime();
    adjointDoubleLayer(surface);
    Info<< "p = " << p << ": single layer " << 1000*single
        << " ms, adjoint double layer "
        << 1000*(clock.elapsedTime() - single) << " ms" << endl;
}


int main()
{
    testSphere(6, 1e-6);
    testSphere(8, 2e-9);
    testSphere(12, 5e-12);
    testTranslation(8, 1e-4, 1e-3);
    testTranslation(12, 1e-5, 1e-4);
    testIdentities("ellipsoid", longEllipsoid, 8, 1e-5);
    testIdentities("ellipsoid", longEllipsoid, 12, 1e-7);
    testIdentities("biconcave", biconcaveCell, 8, 5e-4);
    testIdentities("biconcave", biconcaveCell, 12, 5e-4);
    testInvariance(8);
    testConvergence
    (
        "ellipsoid", unequalEllipsoid, {{6, 1e-3}, {8, 3e-4}, {12, 2e-5}}
    );
    testConvergence("biconcave", biconcaveCell, {{8, 6e-3}, {12, 2e-3}});
    testRevolution(8, 6e-3);
    testRevolution(12, 2e-3);
    testRevolution(16, 7e-4);

    for (const label p : {8, 12, 16})
    {
        time(p);
    }
    return failed;
}


// ************************************************************************* //
