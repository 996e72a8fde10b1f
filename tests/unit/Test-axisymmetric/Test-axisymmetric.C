/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-axisymmetric

Description
    Unit tests of what surfaces of revolution need: the directions of the wedge
    that it runs in, the axisymmetric basis, the jump conditions, cut faces and
    one-sided fits at a sphere of radius 1 in the middle. With a sphere it also
    writes a line of the errors of fits in the flow of a force on it: velocity
    and traction inside, and outside. Returns 1 if one failed.

Usage
    Test-axisymmetric first second along0 along1 axis inner outer

    first, second: directions of the axis and away from it, 0 to 2; along0,
    along1: coordinates of the ends; axis: second coordinate of the axis; inner,
    outer: radii. With an inner radius there is no sphere.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "directionTests.H"
#include "interfaceTests.H"

using namespace Foam;
using namespace Foam::capsule;

//- Nodes of a sphere of radius a
static nodalVectors sphereNodes
(
    const axisymmetricBasis& basis,
    const vector2& centre,
    const scalar a
)
{
    nodalVectors x(basis.size(), 2);
    for (label i = 0; i < basis.size(); ++i)
    {
        const scalar t = theta(basis, i);
        x.row(i) = centre + a*vector2(std::cos(t), std::sin(t));
    }
    return basis.symmetric(x);
}


int main(int argc, char* argv[])
{
    const char* names[] =
    {
        "first", "second", "along0", "along1", "axis", "inner", "outer"
    };
    for (const char* name : names)
    {
        argList::addArgument(name);
    }
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const solvedDirections directions(mesh);
    const auto given = [&](const label i)
    {
        return args.get<scalar>(i);
    };
    const scalar axis = given(5);
    testDirections
    (
        mesh, directions, args.get<label>(1), args.get<label>(2),
        Pair<scalar>(given(3), given(4)), axis, Pair<scalar>(given(6), given(7))
    );
    if (given(6) > 0)
    {
        return verdict();
    }
    testBasis();
    testJumps();

    // A face at the axis is cut as well
    const scalar a = 1;
    const vector2 centre(0.5*(given(3) + given(4)) + 0.0004, axis);
    const scalar h = gMin(directions.widths(mesh)());
    const label half = 1.1547*constant::mathematical::pi*a/h;
    const axisymmetricBasis basis(2*half, axis);
    const closedSurface sphere(basis, sphereNodes(basis, centre, a));

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
    immersedInterface interface
    (
        "sphere", mesh, directions, sphere, oneSidedFit::radius
    );
    testFaces(interface.levelSet(), centre, a);
    testCubics(interface, centre, U, p);
    writeModeErrors(interface, centre, a, U, p);

    return verdict();
}
