/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-rigidShape

Description
    Unit tests of the algebra of rigid motion, in the geometry of the mesh it
    runs in: places, rotations and velocities of nodes, and back; moments of
    inertia; the components of a given motion. Ends with an error if any fails.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "rigidShape.H"
#include "rigidMotion.H"
#include "../Test-contact/ellipsoids.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::capsule;

using constant::mathematical::pi;

//- Semi-axes along the first direction and across
static const scalar semiAxes[2] = {1.3, 0.7};


static scalar largest(const nodalMatrix& v)
{
    return v.size() ? v.cwiseAbs().maxCoeff() : 0;
}


static scalar distance
(
    const rigidShape::place& a,
    const rigidShape::place& b
)
{
    return largest(a.centre - b.centre) + largest(a.rotation - b.rotation);
}


//- A displacement or velocity with all components that there are, its rotation
//  of about an angle
static nodalScalars someStep
(
    const rigidShape& shape,
    const scalar phase,
    const scalar angle
)
{
    nodalScalars result(shape.nModes());
    for (label k = 0; k < result.size(); ++k)
    {
        result(k) = std::sin(phase + 1.7*k);
    }
    if (shape.nRotations())
    {
        result.tail(shape.nRotations()) *=
            angle/result.tail(shape.nRotations()).norm();
    }
    return result;
}


static void testPlaces(const rigidShape& shape, const closedSurface& surface)
{
    Info<< "Places" << endl;
    const rigidShape::place start = shape.start();
    check
    (
        "place of the nodes at the start",
        distance(shape.placeOf(surface.nodes()), start), 1e-13
    );
    check
    (
        "nodes there", largest(shape.nodes(start) - surface.nodes()), 1e-13
    );

    // Almost half a turn
    const nodalScalars first = someStep(shape, 0.3, 3.1);
    const nodalScalars second = someStep(shape, 2.9, 2);
    const rigidShape::place between = shape.moved(start, first);
    const rigidShape::place end = shape.moved(between, second);
    check
    (
        "displacement", largest(shape.displacement(start, between) - first),
        1e-12
    );
    check
    (
        "one from a place that is turned",
        largest(shape.displacement(between, end) - second), 1e-12
    );
    const nodalVectors x = shape.nodes(end);
    check("place of nodes moved twice", distance(shape.placeOf(x), end), 1e-12);

    scalar stretch = 0;
    for (label i = 1; i < x.rows(); ++i)
    {
        stretch = max
        (
            stretch,
            mag
            (
                (x.row(i) - x.row(0)).norm()
              - (surface.nodes().row(i) - surface.nodes().row(0)).norm()
            )
        );
    }
    check("change of distances", stretch, 1e-12);
    check
    (
        "centre of the volume of the moved nodes",
        largest(closedSurface(surface.basis(), x).centroid() - end.centre),
        1e-12
    );
}


static void testVelocities(const rigidShape& shape)
{
    Info<< "Velocities" << endl;
    const rigidShape::place at =
        shape.moved(shape.start(), someStep(shape, 0.8, 1));
    const nodalScalars V = someStep(shape, 4.1, 1.3);
    const nodalVectors x = shape.nodes(at);
    const nodalVectors u = shape.velocity(x, at.centre, V);
    check
    (
        "rigid velocity of velocities",
        largest(shape.velocityOf(x, at.centre, u) - V), 1e-12
    );

    const scalar e = 1e-5;
    const nodalVectors slope =
        (
            shape.nodes(shape.moved(at, e*V))
          - shape.nodes(shape.moved(at, -e*V))
        )/(2*e);
    check("velocity against differences", largest(slope - u), 1e-9);

    // What the best fit leaves has no part of any mode
    nodalVectors v(x.rows(), x.cols());
    for (label i = 0; i < v.size(); ++i)
    {
        v(i) = std::sin(0.9*i) + 0.2*x(i);
    }
    const nodalVectors left =
        v
      - shape.velocity(x, at.centre, shape.velocityOf(x, at.centre, v));
    scalar part = 0;
    for (label k = 0; k < shape.nModes(); ++k)
    {
        part = max(part, mag(dot(left, shape.mode(x, at.centre, k)).sum()));
    }
    check("rigid part of what the fit leaves", part/x.rows(), 1e-12);
}


//- Of an ellipse, a spheroid, an ellipsoid of revolution about the first
//  direction
static void testInertia(const rigidShape& shape, const closedSurface& surface)
{
    Info<< "Inertia" << endl;
    const scalar a = semiAxes[0];
    const scalar b = semiAxes[1];
    const bool plane = surface.nComponents() == 2 && !surface.axisymmetric();
    const scalar volume = (plane ? pi*a : 4*pi/3*a*b)*b;
    nodalMatrix expected(nodalMatrix::Zero(shape.nModes(), shape.nModes()));
    expected.diagonal().setConstant(volume);
    if (plane)
    {
        expected(2, 2) = volume*(sqr(a) + sqr(b))/4;
    }
    else if (surface.spatial())
    {
        expected(3, 3) = volume*2*sqr(b)/5;
        expected(4, 4) = expected(5, 5) = volume*(sqr(a) + sqr(b))/5;
    }
    check
    (
        "volume and moments of inertia",
        largest(shape.volumes(surface) - expected), 1e-10
    );

    const rigidShape::place at =
        shape.moved(shape.start(), someStep(shape, 0.8, 1));
    if (surface.spatial())
    {
        expected.bottomRightCorner(3, 3) =
            at.rotation*nodalMatrix(expected.bottomRightCorner(3, 3))
           *at.rotation.transpose();
    }
    check
    (
        "the same, turned",
        largest
        (
            shape.volumes(closedSurface(surface.basis(), shape.nodes(at)))
          - expected
        ),
        1e-10
    );
}


//- A motion by its text, at a time, against V + W x r of vectors in space
static void checkMotion
(
    const std::string& what,
    const std::string& entries,
    const vector& linear,
    const vector& angular,
    const rigidShape& shape,
    const closedSurface& surface,
    const solvedDirections& directions
)
{
    const rigidMotion motion(dictOf(entries), directions, 0);
    const nodalVectors u = shape.velocity
    (
        surface.nodes(), shape.start().centre, motion.velocity(2)
    );
    scalar error = 0;
    for (label i = 0; i < u.rows(); ++i)
    {
        const vector r = directions.toVector
        (
            surface.nodes().row(i) - shape.start().centre
        );
        error = max
        (
            error,
            mag(directions.toVector(u.row(i)) - linear - (angular ^ r))
        );
    }
    check(what, error, 1e-13);
}


static void testMotion
(
    const rigidShape& shape,
    const closedSurface& surface,
    const solvedDirections& directions
)
{
    Info<< "Motion" << endl;
    const auto checkOne = [&]
    (
        const std::string& what,
        const std::string& entries,
        const vector& linear,
        const vector& angular
    )
    {
        checkMotion
        (
            what, entries, linear, angular, shape, surface, directions
        );
    };
    const auto text = [](const vector& v)
    {
        OStringStream os;
        os << v;
        return os.str();
    };

    // The components that there are
    const vector all(0.4, -1.1, 0.7);
    vector linear(Zero);
    vector angular(Zero);
    for (label i = 0; i < shape.nTranslations(); ++i)
    {
        linear[directions.axis(i)] = all[directions.axis(i)];
    }
    if (shape.nRotations() == 1)
    {
        angular[directions.axis(2)] = 1.9;
    }
    else if (shape.nRotations() == 3)
    {
        angular = vector(-0.6, 0.9, 1.9);
    }
    checkOne("held", "type held;", Zero, Zero);
    checkOne("without entries", "type prescribed;", Zero, Zero);
    checkOne
    (
        "prescribed",
        "type prescribed; velocity " + text(linear) + "; angularVelocity "
      + text(angular) + ";",
        linear,
        angular
    );
    checkOne
    (
        "table of the time",
        "type prescribed; velocity table ((0 (0 0 0)) (4 " + text(linear)
      + "));",
        0.5*linear,
        Zero
    );
    checkOne
    (
        "load",
        "type free; density 3; force " + text(linear) + "; torque "
      + text(angular) + ";",
        linear,
        angular
    );
}


int main(int argc, char* argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const solvedDirections directions(mesh);
    const autoPtr<surfaceBasis> basis(basisIn(directions, 72));
    const closedSurface surface
    (
        *basis, ellipsoid(*basis, 5, semiAxes[0], semiAxes[1])
    );
    const rigidShape shape(surface);
    check
    (
        "components of a velocity",
        shape.nModes()
      - (directions.spatial() ? 6 : directions.axisymmetric() ? 1 : 3),
        0
    );
    testPlaces(shape, surface);
    testVelocities(shape);
    testInertia(shape, surface);
    testMotion(shape, surface, directions);

    return verdict();
}


// ************************************************************************* //
