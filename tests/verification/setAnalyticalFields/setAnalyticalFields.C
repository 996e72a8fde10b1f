/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    setAnalyticalFields

Description
    Sets velocity and pressure of the start time to the case's analytical
    solution.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "analyticalSolution.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    volVectorField U
    (
        IOobject("U", runTime.timeName(), mesh, IOobject::MUST_READ), mesh
    );
    volScalarField p
    (
        IOobject("p", runTime.timeName(), mesh, IOobject::MUST_READ), mesh
    );
    const autoPtr<capsule::analyticalSolution> exact
    (
        capsule::analyticalSolution::New(mesh)
    );
    const capsule::solvedDirections directions(mesh);

    forAll(U, celli)
    {
        const capsule::solvedVector x = directions(mesh.C()[celli]);
        U[celli] = directions.toVector(exact->velocity(x, runTime.value()));
        p[celli] = exact->pressure(x, runTime.value());
    }
    U.correctBoundaryConditions();
    U.write();
    p.write();
    Info<< "End" << endl;

    return 0;
}
