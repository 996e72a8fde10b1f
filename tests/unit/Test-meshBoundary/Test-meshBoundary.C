/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-meshBoundary

Description
    Unit tests of what the boundary of a mesh says about balls, that is circles
    in the plane, and lines between points, against what is known of a channel
    with a post, a stone and a baffle. Ends with an error if any fails.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "boundaryTests.H"
#include "sightTests.H"
#include "clearanceTests.H"

using namespace Foam;
using namespace Foam::capsule;

int main(int argc, char* argv[])
{
    argList args(argc, argv);
    Time runTime(Time::controlDictName, args);

    const char* names[] = {"plane", "space", "periodic"};
    for (label i = 0; i < 3; ++i)
    {
        Info<< nl << "In the " << names[i] << " channel" << endl;
        const autoPtr<fvMesh> mesh
        (
            channelMesh(i == 0, i == 2)(runTime, names[i])
        );
        const solvedDirections directions(*mesh);
        check("solved directions", directions.spatial() - (i > 0), 0);

        const meshBoundary& boundary = meshBoundary::New(*mesh);
        testContents(boundary, directions);
        testDistances(boundary, directions);
        testEnclosed(boundary, directions);
        testSight(*mesh, directions);
        testClearance(*mesh, directions);
        testResolution(*mesh, directions);
        check
        (
            "made anew", &boundary != &meshBoundary::New(*mesh), 0
        );
    }
    Info<< nl << "End" << endl;
    return verdict();
}
