/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    capsuleFoam

Description
    Transient solver for elastic capsules and red blood cells in laminar
    incompressible flow, by the sharp immersed interface method with different
    viscosities inside and outside.

    Each time step
    (A) places the membranes where the step leads them, and sets up the
        momentum equation on either side of them;
    (B) iterates pressure, velocity, membranes and membrane stress until they
        agree to the tolerances; a step in which they do not is taken again in
        parts, or ends the run, see timeStepControl.

    Momentum is divided by mu/mu_out on each side, so that the matrices are
    those of one fluid; p is the scaled pressure while the equations are
    solved, and pressure the real one, see scaledFluid.


\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "flowSolver.H"
#include "boundaryTypes.H"
#include "linearSchemes.H"
#include "membraneSystem.H"
#include "drivingForce.H"
#include "readField.H"
#include "timeStepControl.H"
#include "restartableTime.H"
#include "solverFunctions.H"
#include "functionObject.H"
#include "profiling.H"
#include "sigFpe.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Transient solver for elastic capsules and red blood cells in laminar"
        " incompressible flow."
    );

    capsule::solverFunctions::provide(argc, argv);
    #define CREATE_CONTROL checkFunctions.H
    #include "postProcess.H"

    argList::addBoolOption
    (
        "dry-run",
        "Check the case, membranes in their mesh included, by one time step;"
        " write no times"
    );

    #include "setRootCaseLists.H"
    #include "createTimeAndMesh.H"

    const bool dryRun = args.found("dry-run");
    if (dryRun)
    {
        runTime.stopAt(Time::saNoWriteNow);
        functionObject::outputPrefix = "postProcessing-dry-run";
    }

    capsule::solverFunctions::check(runTime);
    #include "createFields.H"
    #include "createTimeControls.H"
    #include "CourantNo.H"
    #include "setInitialDeltaT.H"

    capsule::timeStepControl step
    (
        runTime, membranes, *flow, *driving, U, p, phi
    );

    membranes.setInsideOfBodies(phi);

    Info<< "\nStarting time loop\n" << endl;

    while (runTime.run())
    {
        #include "readTimeControls.H"
        #include "CourantNo.H"
        #include "setDeltaT.H"

        do
        {
            step.start();

            Info<< "Time = " << runTime.timeName() << nl << endl;

            flow->readIfModified();

            // (A) Membranes of the step, momentum equation
            membranes.predict();
            if (membranes.placed())
            {
                #include "UEqn.H"

                // (B) Pressure, velocity, membranes and their stress
                while (flow->unbalanced().empty() && membranes.loop())
                {
                    #include "pEqn.H"
                    membranes.correct(flow->failure().empty());
                }
            }
        }
        while (step.repeat());

        membranes.setInsideOfBodies(phi);
        membranes.fluid().setPressure();

        if (!dryRun)
        {
            runTime.write();
            if (runTime.writeTime())
            {
                membranes.write();
                runTime.writeManifest(mesh, flow->write());
            }
        }
        runTime.printExecutionTime(Info);
    }

    Info<< "End\n" << endl;

    return 0;
}
