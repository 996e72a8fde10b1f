/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneMeasures.H"
#include "membraneSystem.H"
#include "membraneVtk.H"
#include "meshBoundary.H"
#include "input.H"
#include "unitConversion.H"
#include "releases.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(membraneMeasures, 0);
    addToRunTimeSelectionTable(functionObject, membraneMeasures, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::capsule::membraneSystem&
Foam::functionObjects::membraneMeasures::membranes() const
{
    return mesh_.lookupObject<capsule::membraneSystem>("membraneProperties");
}


Foam::List<const char*>
Foam::functionObjects::membraneMeasures::columns() const
{
    if (membranes().plane().axisymmetric())
    {
        return
        {
            "x", "U", "volume", "surface", "lengthX", "diameter",
            "minStretch", "maxStretch", "minHoopStretch", "maxHoopStretch",
            "minTension", "maxTension", "minHoopTension", "maxHoopTension",
            "gap", "taylorDeformation", "elasticEnergy", "power"
        };
    }
    return
    {
        "x", "y", "U", "V", "area", "perimeter",
        "lengthX", "lengthY", "minStretch", "maxStretch",
        "taylorDeformation", "elasticEnergy", "power",
        "inclination"
    };
}


void Foam::functionObjects::membraneMeasures::writeMeasures
(
    const capsule::membrane& m,
    const scalar gap,
    Ostream& os
) const
{
    using capsule::vector2;

    const capsule::closedSurface curve = m.curve();
    const vector2 centre = curve.centroid();
    const scalar volume = curve.volume();
    const vector2 U = curve.flow(m.now().velocity)/volume;
    const vector2 extents = curve.extents();
    const scalar power = curve.integral(m.power(curve));
    const auto writeRange = [&](const capsule::nodalScalars& field)
    {
        os  << tab << field.minCoeff() << tab << field.maxCoeff();
    };

    os  << mesh_.time().timeOutputValue();
    if (curve.axisymmetric())
    {
        os  << tab << centre(0) << tab << U(0)
            << tab << volume << tab << curve.surface()
            << tab << extents(0) << tab << extents(1);
        writeRange(m.stretch(curve));
        writeRange(m.secondStretch(curve));
        writeRange(m.tension(curve));
        writeRange(m.secondTension(curve));
        os  << tab << gap << tab << curve.taylorDeformation()
            << tab << (m.hasEnergy() ? m.elasticEnergy(curve) : 0)
            << tab << power << endl;
        return;
    }
    os  << tab << centre(0) << tab << centre(1) << tab << U(0) << tab << U(1)
        << tab << volume << tab << curve.surface()
        << tab << extents(0) << tab << extents(1);
    writeRange(m.stretch(curve));
    os  << tab << curve.taylorDeformation()
        << tab << m.elasticEnergy(curve)
        << tab << power
        << tab << radToDeg(curve.inclination()) << endl;
}


void Foam::functionObjects::membraneMeasures::writeVtk
(
    const capsule::membrane& m
) const
{
    const capsule::membraneVtk vtk(m, membranes().plane());
    const fileName dir(baseTimeDir());
    mkDir(dir);
    vtk.writeLine(dir/m.name() + ".vtk");
    writeSeries(m.name() + ".vtk");
    if (membranes().plane().axisymmetric())
    {
        vtk.writeSurface(dir/m.name() + ".surface.vtk");
        writeSeries(m.name() + ".surface.vtk");
    }
}


void Foam::functionObjects::membraneMeasures::writeSeries
(
    const fileName& file
) const
{
    const fileName dir(baseFileDir()/name());
    OFstream os(dir/(file + ".series"));

    os  << "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [";
    const char* separator = "\n";
    for (const instant& time : Time::findTimes(dir))
    {
        if (isFile(dir/time.name()/file))
        {
            os  << separator << "    { \"name\" : \""
                << (time.name()/file).c_str() << "\", \"time\" : "
                << time.value() << " }";
            separator = ",\n";
        }
    }
    os  << "\n  ]\n}\n";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::membraneMeasures::membraneMeasures
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name),
    lines_(false)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::membraneMeasures::read(const dictionary& dict)
{
    capsule::input::warnOfOthers
    (
        dict,
        capsule::input::joined(capsule::input::functionObjectEntries(), {"lines"})
    );
    lines_ = capsule::input::getOrDefault<bool>(dict, "lines", false);
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::membraneMeasures::execute()
{
    return true;
}


bool Foam::functionObjects::membraneMeasures::write()
{
    const capsule::membraneSystem& system = membranes();

    // Walls of all processors
    scalarList gaps(system.size(), Zero);
    if (system.plane().axisymmetric())
    {
        forAll(gaps, i)
        {
            const capsule::closedSurface curve(system[i].curve());
            gaps[i] = capsule::meshBoundary::New(mesh_).toWalls
            (
                curve.sampled(4*curve.size())
            );
        }
    }

    if (!Pstream::master())
    {
        return true;
    }

    if (files_.empty())
    {
        files_.setSize(system.size());
        forAll(files_, i)
        {
            files_.set(i, newFileAtStartTime(system[i].name()));
            files_[i].precision(12);
            writeHeader(files_[i], "Membrane " + system[i].name());
            writeCommented(files_[i], "Time");
            for (const char* column : columns())
            {
                writeTabbed(files_[i], column);
            }
            files_[i] << endl;
        }
    }

    forAll(files_, i)
    {
        writeMeasures(system[i], gaps[i], files_[i]);
        if (lines_)
        {
            writeVtk(system[i]);
        }
    }
    return true;
}
