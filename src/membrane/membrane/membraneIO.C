/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membrane.H"
#include "fvMesh.H"
#include "IOdictionary.H"
#include "passiveParticleCloud.H"
#include "IOField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Where the states of a membrane are written
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


//- Writer of the time levels of a membrane, with all digits
class stateWriter
:
    public regIOobject
{
    const membrane& membrane_;

    const meshPlane& plane_;

public:

    stateWriter(const membrane& m, const meshPlane& plane, const Time& runTime)
    :
        regIOobject(stateFile(m.name(), runTime, IOobject::NO_READ)),
        membrane_(m),
        plane_(plane)
    {}

    //- The file is read as a dictionary
    virtual const word& type() const
    {
        return IOdictionary::typeName;
    }

    virtual bool writeData(Ostream& os) const
    {
        os.precision(17);
        os.writeEntry("oldLevels", membrane_.nOld());
        for (label i = 0; i <= membrane_.nOld(); ++i)
        {
            const membrane::state& s =
                (i == 0 ? membrane_.now() : membrane_.old(i - 1));
            os.beginBlock(word("level" + Foam::name(i)));
            os.writeEntry("points", plane_.toVectors(s.x));
            os.writeEntry("interface", plane_.toVectors(s.interface));
            os.writeEntry("force", plane_.toVectors(s.force));
            os.writeEntry("inertia", plane_.toVectors(s.inertia));
            os.writeEntry("velocity", plane_.toVectors(s.velocity));
            os.endBlock();
        }
        return os.good();
    }
};

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::membrane::readState(const Time& runTime)
{
    IOobject io(stateFile(name_, runTime, IOobject::MUST_READ));
    if (!io.typeHeaderOk<IOdictionary>(false))
    {
        return false;
    }
    const IOdictionary dict(io);

    const auto read = [&](const dictionary& level)
    {
        state s;
        nodalVectors* fields[] =
            {&s.x, &s.interface, &s.force, &s.inertia, &s.velocity};
        const char* names[] =
            {"points", "interface", "force", "inertia", "velocity"};
        for (label i = 0; i < 5; ++i)
        {
            const vectorField field(level.get<vectorField>(names[i]));
            if (field.size() != size())
            {
                FatalIOErrorInFunction(level)
                    << "Entry " << names[i] << " has " << field.size()
                    << " points, but membrane " << name_ << " has " << size()
                    << exit(FatalIOError);
            }
            *fields[i] = plane_.toNodes(field);
        }
        return s;
    };

    now_ = read(dict.subDict("level0"));
    old_.setSize(dict.get<label>("oldLevels"));
    forAll(old_, i)
    {
        old_[i] = read(dict.subDict("level" + Foam::name(i + 1)));
    }

    Info<< "Membrane " << name_ << ": goes on from " << dict.objectPath()
        << endl;
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::membrane::write(const Time& runTime) const
{
    stateWriter(*this, plane_, runTime).write();
}


void Foam::capsule::membrane::writeCloud(const fvMesh& mesh) const
{
    const closedCurve now(curve());
    const pointField points(plane_.toPoints(now.nodes()));
    const vectorField velocity(plane_.toVectors(now_.velocity));
    const vectorField force
    (
        plane_.toVectors(this->force(now, now.metric()))
    );
    const nodalScalars stretch = this->stretch(now);
    const nodalScalars tension = this->tension(now);

    // Each point has one owner: the lowest processor that finds it
    passiveParticleCloud cloud(mesh, name_, IDLList<passiveParticle>());
    DynamicList<label> mine;
    forAll(points, i)
    {
        const label celli = mesh.findCell(points[i]);
        const label owner = returnReduce
        (
            celli == -1 ? Pstream::nProcs() : Pstream::myProcNo(),
            minOp<label>()
        );
        if (owner == Pstream::myProcNo())
        {
            cloud.addParticle(new passiveParticle(mesh, points[i], celli));
            mine.append(i);
        }
    }
    cloud.write();

    const auto io = [&](const word& field)
    {
        return IOobject
        (
            field,
            mesh.time().timeName(),
            cloud,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        );
    };
    IOField<vector>(io("velocity"), vectorField(velocity, mine)).write();
    IOField<vector>(io("force"), vectorField(force, mine)).write();

    IOField<scalar> stretchField(io("stretch"), mine.size());
    IOField<scalar> tensionField(io("tension"), mine.size());
    forAll(mine, i)
    {
        stretchField[i] = stretch(mine[i]);
        tensionField[i] = tension(mine[i]);
    }
    stretchField.write();
    tensionField.write();
}
