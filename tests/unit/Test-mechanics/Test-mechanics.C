/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-mechanics

Description
    Unit tests of elastic laws of two stretches, bending and the force of
    membranes in the plane and of surfaces of revolution, of the measures of
    these, and of shapes in the wedge or plane of the case it runs in, against
    exact values and differences. Ends with an error if any fails.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "shapeTests.H"
#include "viscosityTests.H"

using namespace Foam;
using namespace Foam::capsule;

//- Surface of a spheroid, semi-axis a along the axis, b away from it
static scalar spheroidSurface(const scalar a, const scalar b)
{
    const scalar e = std::sqrt(mag(1 - sqr(min(a, b)/max(a, b))));
    return
        a > b
      ? 2*capsule::pi*b*b*(1 + a/(b*e)*std::asin(e))
      : 2*capsule::pi*b*b*(1 + (1 - e*e)/e*std::atanh(e));
}


static void testMeasures()
{
    for (const scalar b : {0.7, 1.0, 1.4})
    {
        const auto basis = basisOf(64, false);
        const closedSurface s(*basis, ellipseOf(*basis, 1, b, 0, 0.1));
        const scalar surface = (b == 1 ? 4*capsule::pi : spheroidSurface(1, b));
        check("volume of a spheroid", s.volume() - 4*capsule::pi/3*b*b, 1e-10);
        check("surface of a spheroid", s.area() - surface, 1e-10);
        check("centroid along the axis", s.centroid()(0) - 5, 1e-10);
        check("centroid on the axis", s.centroid()(1) - axisAt, 1e-10);
        check
        (
            "Taylor deformation of a spheroid",
            s.taylorDeformation() - mag(1 - b)/(1 + b), b == 1 ? 1e-7 : 1e-10
        );
    }
}


int main(int argc, char* argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const solvedDirections directions(mesh);
    if (directions.axisymmetric())
    {
        testWedgeShapes(directions);
        testWedgeRefusals(directions);
        testLaws();
        testMeasures();
        testSphere();
        testPower();
        testJacobian();
        testCompression();
        testBending();
        testViscousSphere();
        testViscousTensions();
        testViscousJacobian();
        testViscousCompression();
    }
    else
    {
        testPlaneShapes(directions);
    }

    return verdict();
}
