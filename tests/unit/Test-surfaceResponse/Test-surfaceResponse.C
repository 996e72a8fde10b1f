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

#include "exactTests.H"
#include "identityTests.H"
#include "testSurfaces.H"
#include "ringResponse.H"
#include "clockTime.H"
#include <map>

using namespace Foam;
using namespace Foam::capsule;

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
    return nFailed();
}


// ************************************************************************* //
