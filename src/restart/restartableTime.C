/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "restartableTime.H"
#include "wholeFile.H"
#include "input.H"
#include "IOdictionary.H"
#include "localIOdictionary.H"
#include "argList.H"
#include "fileOperation.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::capsule::restartableTime::timeFile
(
    const IOobject::readOption read
) const
{
    return IOobject
    (
        "time",
        timeName(),
        "uniform",
        *this,
        read,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::capsule::restartableTime::writeTimeDict(const fileNameList* files) const
{
    IOdictionary dict(timeFile(IOobject::NO_READ));

    dict.add("value", value());
    dict.add("name", string(timeName()));
    dict.add("index", timeIndex());
    dict.add("deltaT", deltaTValue());
    dict.add("deltaT0", deltaT0Value());
    dict.add("writeOrigin", writeOrigin_);
    if (files)
    {
        dict.add("files", *files);
    }
    writeAtomically(dict, IOstream::ASCII);
}


void Foam::capsule::restartableTime::checkFiles(const dictionary& dict) const
{
    if (!dict.found("files"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry files is missing: the run that wrote this time was"
            << " stopped before it was whole" << nl
            << "    To go on from an earlier time, remove the directory "
            << timePath() << nl
            << "    If another program has written it, remove uniform/time in"
            << " it: membranes then start from their shapes."
            << exit(FatalIOError);
    }
    for (const fileName& file : input::get<fileNameList>(dict, "files"))
    {
        const string wrong(fileDefect(timePath()/file));
        if (!wrong.empty())
        {
            FatalErrorInFunction
                << "The file " << timePath()/file << ' ' << wrong.c_str() << nl
                << "    To go on from an earlier time, remove the directory "
                << timePath() << exit(FatalError);
        }
    }
}


void Foam::capsule::restartableTime::resume()
{
    // Not an IOdictionary: that of each processor, for its own files
    IOobject io(timeFile(IOobject::MUST_READ));
    if (!io.typeHeaderOk<localIOdictionary>(false))
    {
        FatalErrorInFunction
            << "The file " << timePath()/"uniform"/"time"
            << " is missing or damaged: no header" << nl
            << "    To go on from an earlier time, remove the directory "
            << timePath() << exit(FatalError);
    }
    const localIOdictionary dict(io, IOdictionary::typeName);
    if (input::get<label>(dict, "index") == 0)
    {
        return;
    }

    checkFiles(dict);

    const auto seconds = [&](const word& entry, const scalar least)
    {
        return input::getBetween<scalar>(dict, entry, least, input::largest);
    };
    seconds("deltaT0", input::smallest);
    deltaTSave_ = seconds("deltaT", input::smallest);
    const scalar exact = seconds("value", -input::largest);
    const scalar origin = seconds("writeOrigin", -input::largest);
    if (input::get<string>(dict, "name") != timeName())
    {
        // Copied to another time: OpenFOAM has warned of it
        return;
    }
    if (mag(exact - value()) > deltaTSave_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry value is " << exact << ", not that of the time "
            << timeName() << ": the file is damaged or was edited"
            << exit(FatalIOError);
    }
    if (timeName(exact) == timeName())
    {
        // Else the run goes on with another timePrecision
        setTime(exact, timeIndex());
    }

    if (writeControl_ == wcRunTime || writeControl_ == wcAdjustableRunTime)
    {
        writeOrigin_ = origin;
        writeTimeIndex_ =
            label((exact - writeOrigin_ + 0.5*deltaTSave_)/writeInterval_);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::restartableTime::restartableTime(const argList& args)
:
    Time(Time::controlDictName, args),
    writeOrigin_(startTime_)
{
    if (Pstream::parRun() && fileHandler().type() != "uncollated")
    {
        FatalErrorInFunction
            << "The fileHandler is " << fileHandler().type()
            << "; permitted in parallel: uncollated" << nl
            << "    Each processor has files of its own that a restart needs."
            << exit(FatalError);
    }
    const bool begun = isFile(timePath()/"uniform"/"time");
    if (returnReduce(begun, orOp<bool>()))
    {
        resume();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::restartableTime& Foam::capsule::restartableTime::operator++()
{
    const scalar start = startTime_;
    startTime_ = writeOrigin_;
    Time::operator++();
    startTime_ = start;
    return *this;
}


void Foam::capsule::restartableTime::setDeltaT(const scalar deltaT)
{
    if (writeControl_ != wcAdjustableRunTime)
    {
        Time::setDeltaT(deltaT);
        return;
    }

    // As Time adjusts it: up to twice as long, not less than a fifth
    const scalar left =
        max
        (
            scalar(0),
            (writeTimeIndex_ + 1)*writeInterval_ - (value() - writeOrigin_)
        );
    const scalar steps = max(scalar(1), std::round(left/deltaT));
    const scalar adjusted =
        min(max(left/steps, 0.2*deltaT), 2*deltaT);

    // The rest is for the function objects to adjust
    writeControl_ = wcNone;
    Time::setDeltaT(adjusted);
    writeControl_ = wcAdjustableRunTime;
}


bool Foam::capsule::restartableTime::writeTimeDict() const
{
    writeTimeDict(nullptr);
    return true;
}


bool Foam::capsule::restartableTime::write(const bool valid) const
{
    FIFOStack<word> written(previousWriteTimes_);
    previousWriteTimes_.clear();
    const bool good = Time::write(valid);
    if (!previousWriteTimes_.empty())
    {
        written.push(previousWriteTimes_.pop());
    }
    previousWriteTimes_ = written;

    if (writeTime() && !good)
    {
        FatalErrorInFunction
            << "Cannot write all files of " << timePath()
            << ": is the disk full?" << nl
            << "    This time is not whole: remove its directory to go on from"
            << " an earlier one." << exit(FatalError);
    }
    return good;
}


void Foam::capsule::restartableTime::writeManifest
(
    const fvMesh& mesh,
    const fileNameList& otherFiles
) const
{
    fileNameList files(otherFiles);
    const HashTable<const regIOobject*> objects
    (
        mesh.lookupClass<regIOobject>()
    );
    forAllConstIters(objects, iter)
    {
        const regIOobject& object = **iter;
        const bool isRead =
            object.readOpt() != IOobject::NO_READ
         || object.name().endsWith("_0");
        if
        (
            isRead && object.writeOpt() == IOobject::AUTO_WRITE
         && object.instance() == timeName()
        )
        {
            files.append(object.local()/object.name());
        }
    }
    sort(files);

    for (const fileName& file : files)
    {
        const string wrong(fileDefect(timePath()/file));
        if (!wrong.empty())
        {
            FatalErrorInFunction
                << "Cannot write " << timePath()/file << ", which "
                << wrong.c_str() << ": is the disk full?" << nl
                << "    This time is not whole: remove its directory to go on"
                << " from an earlier one." << exit(FatalError);
        }
    }
    writeTimeDict(&files);

    // Whole on all processors
    if (returnReduce(purgeWrite_ > 0, orOp<bool>()))
    {
        while (previousWriteTimes_.size() > purgeWrite_)
        {
            fileHandler().rmDir
            (
                fileHandler().filePath(path()/previousWriteTimes_.pop())
            );
        }
    }
}
