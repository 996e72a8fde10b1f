/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-surface

Description
    Unit tests of closed surfaces in space, their unknowns, jump conditions and
    cubic fits; and, at a sphere of radius 1 in the cube of N^3 cells that it
    runs in, of the level set, cut faces and one-sided fits. Writes a line of
    the largest error of the sphere's cross sections in planes of faces, over
    the largest of them. Returns 1 if one failed.

Usage
    Test-surface N

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "geometryTests.H"
#include "footTests.H"
#include "forceTests.H"
#include "unknownTests.H"
#include "jumpTests.H"
#include "faceTests.H"

using namespace Foam;
using namespace Foam::capsule;

int main(int argc, char* argv[])
{
    argList::addArgument("N");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    for
    (
        const labelPair& pq :
        {labelPair(2, 4), labelPair(4, 6), labelPair(8, 12)}
    )
    {
        testMeasures(pq.first(), pq.second());
        testCurvatures(pq.first(), pq.second());
        testHarmonics(pq.first(), pq.second());
        testDerivatives(pq.first(), pq.second());
        testFeet(pq.first(), pq.second());
        testForces(pq.first(), pq.second());
        testUnknowns(pq.first(), pq.second());
    }
    testArea();
    testIdentities();
    testJumps();
    testCubicFit();

    const scalar a = 1;
    const solvedVector centre = vector3(0.013, 0.027, -0.041);
    const sphericalBasis basis(4, 6);
    const closedSurface sphere
    (
        basis, (a*parametersOf(basis)).rowwise() + centre
    );
    const solvedDirections directions(mesh);
    volVectorField U
    (
        IOobject("U", runTime.timeName(), mesh),
        mesh, dimensionedVector(dimVelocity, Zero)
    );
    volScalarField p
    (
        IOobject("p", runTime.timeName(), mesh),
        mesh, dimensionedScalar(dimPressure, Zero)
    );
    const immersedInterface interface
    (
        "sphere", mesh, directions, sphere, oneSidedFit::radius
    );
    testLevelSet(interface.levelSet(), centre, a);
    testLinks(interface.levelSet());
    testCubics(interface, centre, U, p);
    const scalar error =
        sectionError(interface.levelSet(), centre, a, args.get<label>(1));
    Info<< "sections " << error << endl;

    return verdict();
}
