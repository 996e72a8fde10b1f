/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-shapes

Description
    Unit tests of the initial shapes of membranes in space, against their
    formulas. Ends with an error if any fails.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "fileTests.H"

using namespace Foam;
using namespace Foam::capsule;

int main(int argc, char* argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const solvedDirections directions(mesh);
    capsule::testSphere(directions);
    testEllipsoid(directions);
    testBiconcave(directions);
    testTurning(directions);
    testRefusals(directions);
    testFiles(directions);
    testFormats(directions);
    testFileRefusals(directions);

    return verdict();
}
