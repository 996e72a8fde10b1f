/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "timeStepControl.H"
#include "input.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::timeStepControl::grow()
{
    if (cuts_ == 0)
    {
        return;
    }
    ++taken_;
    scalar deltaT = time_.deltaTValue();
    while (cuts_ > 0 && taken_ % 2 == 0)
    {
        taken_ /= 2;
        --cuts_;
        deltaT *= 2;
    }
    time_.Time::setDeltaT(deltaT, false);
}


void Foam::capsule::timeStepControl::goBack()
{
    // A step that is refused before its flow has touched the time alone
    if (membranes_.placed())
    {
        if (U_.older())
        {
            start_.setFirst();
        }
        U_.restore();
        p_.restore();
        phi_.restore();
        driving_.found(force_);
        flow_.restore();
    }
    static_cast<TimeState&>(time_) = start_;
    membranes_.restore();
}


void Foam::capsule::timeStepControl::end(const string& failure)
{
    const bool first = (time_.timeIndex() == time_.startTimeIndex());
    if (!first)
    {
        time_.writeAndEnd();
        membranes_.write();
        time_.writeManifest(mesh_, flow_.write());
    }

    FatalErrorInFunction
        << "The run ends at time " << time_.timeName() << ": "
        << failure.c_str() << nl
        << (
               first
             ? "    It has taken no step: nothing is written."
             : "    Its state is written, to restart from."
           )
        << " See deltaT, capsuleFoam.flow in " << mesh_.solutionDict().name()
        << ", and elasticLaw, bending, viscosity and coupling in "
        << membranes_.objectPath() << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::timeStepControl::timeStepControl
(
    restartableTime& runTime,
    membraneSystem& membranes,
    flowSolver& flow,
    drivingForce& driving,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi
)
:
    mesh_(U.mesh()),
    time_(runTime),
    membranes_(membranes),
    flow_(flow),
    driving_(driving),
    U_(U),
    p_(p),
    phi_(phi),
    force_(Zero),
    start_(runTime),
    maxCuts_(0),
    minDeltaT_(0),
    cuts_(0),
    taken_(0)
{
    const dictionary& dict = membranes.subDict("coupling");
    const word entry("failedStep");
    const bool cut =
        !dict.found(entry)
     || input::choice(dict, entry, {"cut", "stop"}) == "cut";
    const label most =
        input::getBetweenOrDefault<label>(dict, "maxCuts", 8, 1, 30);
    if (cut)
    {
        maxCuts_ = most;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::timeStepControl::start()
{
    start_ = timeAtStart(time_);
    U_.store();
    p_.store();
    phi_.store();
    force_ = driving_.force();

    // Cut again and again, an adjustable step may become ever smaller
    const scalar decay = time_.isAdjustTimeStep() ? 0.9 : 1;
    minDeltaT_ = max(time_.deltaTValue()/pow(2, maxCuts_), decay*minDeltaT_);

    ++time_;
}


bool Foam::capsule::timeStepControl::repeat()
{
    const bool balanced = flow_.unbalanced().empty();
    const bool solved = flow_.failure().empty();
    if (balanced && solved && membranes_.converged())
    {
        flow_.sayContinuityErrors(membranes_.fluid().sources());
        grow();
        return false;
    }
    const string failure =
        !balanced ? flow_.unbalanced()
      : !solved ? flow_.failure()
      : membranes_.failure();

    const word failed(time_.timeName());
    const scalar deltaT = time_.deltaTValue();
    goBack();

    // What the boundaries give changes little with the step
    if
    (
        !balanced
     || deltaT < 1.5*minDeltaT_
     || time_.stopAt() == Time::saNoWriteNow
    )
    {
        end(failure);
        return false;
    }

    Info<< "Step to " << failed << " failed: "
        << failure.c_str() << "; again with half of it" << nl
        << endl;
    time_.Time::setDeltaT(0.5*deltaT, false);
    if (!time_.isAdjustTimeStep())
    {
        ++cuts_;
        taken_ *= 2;
    }
    return true;
}
