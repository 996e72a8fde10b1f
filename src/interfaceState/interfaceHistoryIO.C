/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "interfaceHistory.H"
#include "wholeFile.H"
#include "input.H"
#include "OSHA1stream.H"
#include "sigFpe.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Where the states of an interface are written
static IOobject stateFile
(
    const word& name,
    const Time& runTime,
    const IOobject::readOption read
)
{
    return IOobject
    (
        name,
        runTime.timeName(),
        "uniform/membranes",
        runTime,
        read,
        IOobject::NO_WRITE,
        false
    );
}


//- The fields of a time level
static const struct
{
    const char* name;
    nodalVectors interfaceState::* field;
}
stateFields[] =
{
    {"points", &interfaceState::x},
    {"interface", &interfaceState::interface},
    {"force", &interfaceState::force},
    {"inertia", &interfaceState::inertia},
    {"velocity", &interfaceState::velocity},
    {"vorticity", &interfaceState::vorticity}
};

//- Version of the file: the first had vorticity and pressure in one field
static const label stateVersion = 2;


//- Digest of the fields of all time levels, by which damage is found
class stateDigest
{
    OSHA1stream os_;

public:

    stateDigest()
    {
        os_.precision(17);
    }

    //- Add a number, zero as it is read: without sign
    void add(const scalar x)
    {
        os_ << (mag(x) > VSMALL ? x : 0) << ' ';
    }

    void add(const scalarField& field)
    {
        for (const scalar x : field)
        {
            add(x);
        }
    }

    void add(const vectorField& field)
    {
        for (const vector& v : field)
        {
            for (const scalar x : v)
            {
                add(x);
            }
        }
    }

    string str()
    {
        return os_.digest().str();
    }
};


//- Writer of the time levels
class stateWriter
:
    public regIOobject
{
    const interfaceHistory& history_;

    const solvedDirections& directions_;

public:

    stateWriter
    (
        const interfaceHistory& history,
        const solvedDirections& directions,
        const Time& runTime
    )
    :
        regIOobject(stateFile(history.name(), runTime, IOobject::NO_READ)),
        history_(history),
        directions_(directions)
    {}

    //- The file is read as a dictionary
    virtual const word& type() const
    {
        return IOdictionary::typeName;
    }

    virtual bool writeData(Ostream& os) const
    {
        stateDigest digest;
        os.writeEntry("version", stateVersion);
        os.writeEntry("oldLevels", history_.nOld());
        for (label i = 0; i <= history_.nOld(); ++i)
        {
            const interfaceState& s =
                (i == 0 ? history_.now() : history_.old(i - 1));
            os.beginBlock(word("level" + Foam::name(i)));
            for (const auto& entry : stateFields)
            {
                const vectorField field(directions_.toVectors(s.*entry.field));
                digest.add(field);
                // With the type of the list, which binary files need
                const UList<vector>& list = field;
                list.writeEntry(entry.name, os);
            }
            const scalarField pressure
            (
                UList<scalar>
                (
                    const_cast<scalar*>(s.pressure.data()), s.pressure.size()
                )
            );
            digest.add(pressure);
            const UList<scalar>& list = pressure;
            list.writeEntry("pressure", os);
            os.endBlock();
        }
        os.writeEntry("digest", digest.str());
        return os.good();
    }
};


//- A time level, of an interface of n points; its fields go to the digest
static interfaceState stateOf
(
    const dictionary& level,
    const solvedDirections& directions,
    const label n,
    const string& called,
    stateDigest& digest
)
{
    const auto check = [&](const word& entry, const label size)
    {
        if (size != n)
        {
            FatalIOErrorInFunction(level)
                << "Entry " << entry << " has " << size << " points, but "
                << called.c_str() << " has " << n << exit(FatalIOError);
        }
    };
    interfaceState s;
    for (const auto& entry : stateFields)
    {
        const vectorField field(input::get<vectorField>(level, entry.name));
        check(entry.name, field.size());
        digest.add(field);
        s.*entry.field = directions.toNodes(field);
    }
    const scalarField pressure(input::get<scalarField>(level, "pressure"));
    check("pressure", pressure.size());
    digest.add(pressure);
    s.pressure =
        Eigen::Map<const nodalScalars>(pressure.cdata(), pressure.size());
    return s;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::interfaceHistory::checkStart
(
    const dictionary& file,
    const Time& runTime,
    const fileName& missing
) const
{
    const scalar start = input::getBetweenOrDefault<scalar>
    (
        file, "startTime", 0, -input::largest, input::largest
    );
    const bool atStart =
        Time::timeName(start) == Time::timeName(runTime.value());

    if (!atStart)
    {
        FatalIOErrorInFunction(file)
            << "The state of " << called_.c_str() << ", " << missing
            << ", is missing, and the time " << runTime.timeName()
            << " is not that at which membranes have their shapes, startTime "
            << start << nl
            << "    If it has been lost, go on from an earlier time. To start"
            << " membranes from their shapes at this time, in fields of another"
            << " program, set startTime " << runTime.timeName() << "; in "
            << file.name() << exit(FatalIOError);
    }
    if
    (
        !file.found("startTime")
     && (
            runTime.timeIndex() > 0
         || isFile(runTime.timePath()/"levelSet." + name_)
        )
    )
    {
        FatalErrorInFunction
            << "The state of " << called_.c_str() << ", "
            << missing << ", is missing, but a run has written"
            << " this time" << nl
            << "    To start membranes from their shapes, remove"
            << " uniform/time and the files levelSet.* there."
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::capsule::interfaceHistory::read
(
    const dictionary& properties,
    const Time& runTime
)
{
    IOobject io(stateFile(name_, runTime, IOobject::MUST_READ));
    if (!io.typeHeaderOk<IOdictionary>(false))
    {
        if (isFile(io.objectPath()))
        {
            FatalErrorInFunction
                << "The state of " << called_.c_str() << " in "
                << io.objectPath() << " is damaged: no header"
                << exit(FatalError);
        }
        checkStart(properties, runTime, io.objectPath());
        return false;
    }
    sigFpe::ignore untrapped;
    const autoPtr<IOdictionary> file = input::guarded
    (
        dictionary(io.objectPath()),
        "level",
        [&]() { return autoPtr<IOdictionary>(new IOdictionary(io)); }
    );
    untrapped.restore();
    const IOdictionary& dict = *file;
    const label version = input::getOrDefault<label>(dict, "version", 1);
    if (version != stateVersion)
    {
        FatalIOErrorInFunction(dict)
            << "Entry version is " << version << ": the state of "
            << called_.c_str() << " is that of another version of the program;"
            << " permitted: " << stateVersion << exit(FatalIOError);
    }

    stateDigest digest;
    const auto readLevel = [&](const label i)
    {
        return stateOf
        (
            input::subDict(dict, "level" + Foam::name(i)), directions_,
            now_.x.rows(), called_, digest
        );
    };
    now_ = readLevel(0);
    old_.setSize(input::getBetween<label>(dict, "oldLevels", 0, 2));
    forAll(old_, i)
    {
        old_[i] = readLevel(i + 1);
    }

    if (input::get<string>(dict, "digest") != digest.str())
    {
        FatalIOErrorInFunction(dict)
            << "Entry digest is not that of the points and fields: the state"
            << " of " << called_.c_str() << " is damaged or was edited"
            << exit(FatalIOError);
    }

    string title(called_);
    title[0] = std::toupper(title[0]);
    Info<< title.c_str() << ": goes on from " << dict.objectPath()
        << endl;
    return true;
}


void Foam::capsule::interfaceHistory::write(const Time& runTime) const
{
    writeAtomically
    (
        stateWriter(*this, directions_, runTime),
        runTime.writeFormat()
    );
}


// ************************************************************************* //
