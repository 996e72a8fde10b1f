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


void Foam::functionObjects::membraneMeasures::writeMeasures
(
    const capsule::membrane& m,
    Ostream& os
) const
{
    using capsule::nodalScalars;
    using capsule::vector2;

    const capsule::closedSurface curve = m.curve();
    const scalar area = curve.area();
    const vector2 c = curve.centroid();
    const vector2 extents = curve.extents();
    const nodalScalars stretch = m.stretch(curve);

    // Mean velocity of the enclosed area by the divergence theorem
    const nodalScalars un = capsule::dot(m.now().velocity, curve.normal());
    const capsule::nodalVectors x = curve.nodes().rowwise() - c;
    const scalar U = curve.integral(x.col(0).cwiseProduct(un))/area;
    const scalar V = curve.integral(x.col(1).cwiseProduct(un))/area;

    os  << mesh_.time().timeOutputValue()
        << tab << c(0) << tab << c(1) << tab << U << tab << V
        << tab << area << tab << curve.perimeter()
        << tab << extents(0) << tab << extents(1)
        << tab << stretch.minCoeff() << tab << stretch.maxCoeff()
        << tab << curve.taylorDeformation()
        << tab << m.elasticEnergy(curve)
        << tab << curve.integral(m.power(curve))
        << tab << radToDeg(curve.inclination()) << endl;
}


void Foam::functionObjects::membraneMeasures::writeLine
(
    const capsule::membrane& m
) const
{
    const capsule::membraneSystem& system = membranes();
    const capsule::closedSurface curve = m.curve();
    const label n = curve.size();
    // In a periodic mesh the image whose centroid lies in the mesh
    const capsule::vector2 centre = curve.centroid();
    const pointField x
    (
        system.plane().toPoints
        (
            curve.nodes().rowwise() + (system.plane().images().wrapped(centre) - centre)
        )
    );
    const vectorField U(system.plane().toVectors(m.now().velocity));
    const vectorField F
    (
        system.plane().toVectors(m.force(curve, curve.areaElement()))
    );
    const capsule::nodalScalars stretch = m.stretch(curve);
    const capsule::nodalScalars tension = m.tension(curve);

    const fileName dir(baseTimeDir());
    mkDir(dir);
    OFstream os(dir/m.name() + ".vtk");

    os  << "# vtk DataFile Version 2.0" << nl << m.name() << nl
        << "ASCII" << nl << "DATASET POLYDATA" << nl
        << "POINTS " << n << " float" << nl;
    for (const point& p : x)
    {
        os  << p.x() << ' ' << p.y() << ' ' << p.z() << nl;
    }
    os  << "LINES 1 " << n + 2 << nl << n + 1;
    for (label i = 0; i <= n; ++i)
    {
        os  << ' ' << i % n;
    }
    os  << nl << "POINT_DATA " << n << nl;
    const auto writeVectors = [&](const char* name, const vectorField& field)
    {
        os  << "VECTORS " << name << " float" << nl;
        for (const vector& v : field)
        {
            os  << v.x() << ' ' << v.y() << ' ' << v.z() << nl;
        }
    };
    writeVectors("velocity", U);
    writeVectors("force", F);
    os  << "SCALARS stretch float 1" << nl << "LOOKUP_TABLE default" << nl;
    for (label i = 0; i < n; ++i)
    {
        os  << stretch(i) << nl;
    }
    os  << "SCALARS tension float 1" << nl << "LOOKUP_TABLE default" << nl;
    for (label i = 0; i < n; ++i)
    {
        os  << tension(i) << nl;
    }
}


void Foam::functionObjects::membraneMeasures::writeSeries
(
    const capsule::membrane& m
) const
{
    const fileName dir(baseFileDir()/name());
    const word line(m.name() + ".vtk");
    OFstream os(dir/(line + ".series"));

    os  << "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [";
    const char* separator = "\n";
    for (const instant& time : Time::findTimes(dir))
    {
        if (isFile(dir/time.name()/line))
        {
            os  << separator << "    { \"name\" : \""
                << (time.name()/line).c_str() << "\", \"time\" : "
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
            for
            (
                const char* column :
                {
                    "x", "y", "U", "V", "area", "perimeter",
                    "lengthX", "lengthY", "minStretch", "maxStretch",
                    "taylorDeformation", "elasticEnergy", "power",
                    "inclination"
                }
            )
            {
                writeTabbed(files_[i], column);
            }
            files_[i] << endl;
        }
    }

    forAll(files_, i)
    {
        writeMeasures(system[i], files_[i]);
        if (lines_)
        {
            writeLine(system[i]);
            writeSeries(system[i]);
        }
    }
    return true;
}
