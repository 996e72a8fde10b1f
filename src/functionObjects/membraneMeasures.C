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
#include "surfaceVtk.H"
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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{

static void writeVector(const capsule::solvedVector& v, Ostream& os)
{
    for (Eigen::Index i = 0; i < v.size(); ++i)
    {
        os  << tab << v(i);
    }
}


static void writeRange(const capsule::nodalScalars& field, Ostream& os)
{
    os  << tab << field.minCoeff() << tab << field.maxCoeff();
}


// Distance from walls, if there are any
static void writeGap(const scalar gap, Ostream& os)
{
    if (gap < GREAT)
    {
        os  << tab << gap;
    }
    else
    {
        os  << tab << "nan";
    }
}

} // End namespace functionObjects
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<const char*>
Foam::functionObjects::membraneMeasures::columns() const
{
    if (membranes().directions().axisymmetric())
    {
        return
        {
            "x", "U", "volume", "surface", "lengthX", "diameter",
            "minStretch", "maxStretch", "minHoopStretch", "maxHoopStretch",
            "minTension", "maxTension", "minHoopTension", "maxHoopTension",
            "gap", "taylorDeformation", "elasticEnergy", "power"
        };
    }
    if (membranes().directions().spatial())
    {
        return
        {
            "x", "y", "z", "U", "V", "W", "volume", "surface",
            "lengthX", "lengthY", "lengthZ",
            "longAxis", "middleAxis", "shortAxis",
            "minStretch", "maxStretch", "minSecondStretch", "maxSecondStretch",
            "minTension", "maxTension", "minSecondTension", "maxSecondTension",
            "gap", "taylorDeformation", "elasticEnergy", "bendingEnergy",
            "power", "inclination"
        };
    }
    return
    {
        "x", "y", "U", "V", "area", "perimeter",
        "lengthX", "lengthY", "minStretch", "maxStretch",
        "taylorDeformation", "elasticEnergy", "power",
        "inclination", "gap"
    };
}


void Foam::functionObjects::membraneMeasures::writeMeasures
(
    const capsule::membrane& m,
    const scalar gap,
    Ostream& os
) const
{
    os  << mesh_.time().timeOutputValue();

    const capsule::closedSurface surface = m.surface();
    if (surface.spatial())
    {
        writeSpatial(m, gap, os);
        return;
    }
    const capsule::solvedVector centre = surface.centroid();
    const scalar volume = surface.volume();
    const capsule::solvedVector U = surface.flow(m.now().velocity)/volume;
    const capsule::solvedVector extents = surface.extents();
    const scalar power = surface.integral(m.power(surface));
    const capsule::membraneMechanics::principalValues p = m.principal(surface);

    if (surface.axisymmetric())
    {
        os  << tab << centre(0) << tab << U(0)
            << tab << volume << tab << surface.area()
            << tab << extents(0) << tab << extents(1);
        for (const capsule::nodalScalars* field : {&p.l1, &p.l2, &p.T1, &p.T2})
        {
            writeRange(*field, os);
        }
        writeGap(gap, os);
        os  << tab << surface.taylorDeformation()
            << tab << (m.hasEnergy() ? m.elasticEnergy(surface) : 0)
            << tab << power << endl;
        return;
    }
    os  << tab << centre(0) << tab << centre(1) << tab << U(0) << tab << U(1)
        << tab << volume << tab << surface.area()
        << tab << extents(0) << tab << extents(1);
    writeRange(p.l1, os);
    os  << tab << surface.taylorDeformation()
        << tab << m.elasticEnergy(surface)
        << tab << power
        << tab << radToDeg(surface.inclination());
    writeGap(gap, os);
    os  << endl;
}


void Foam::functionObjects::membraneMeasures::writeSpatial
(
    const capsule::membrane& m,
    const scalar gap,
    Ostream& os
) const
{
    const capsule::closedSurface surface = m.surface();
    const scalar volume = surface.volume();
    const capsule::membraneMechanics::principalValues p = m.principal(surface);

    writeVector(surface.centroid(), os);
    writeVector(surface.flow(m.now().velocity)/volume, os);
    os  << tab << volume << tab << surface.area();
    writeVector(surface.extents(), os);

    const capsule::solvedVector axes = surface.semiAxes();
    if (axes.size())
    {
        writeVector(axes, os);
    }
    else
    {
        os  << tab << "nan" << tab << "nan" << tab << "nan";
    }
    for (const capsule::nodalScalars* field : {&p.l1, &p.l2, &p.T1, &p.T2})
    {
        writeRange(*field, os);
    }
    writeGap(gap, os);
    os  << tab << surface.taylorDeformation()
        << tab << (m.hasEnergy() ? m.elasticEnergy(surface) : 0)
        << tab << m.bendingEnergy(surface)
        << tab << surface.integral(m.power(surface))
        << tab << radToDeg(surface.inclination()) << endl;
}


void Foam::functionObjects::membraneMeasures::writeVtk
(
    const capsule::membrane& m
) const
{
    const capsule::closedSurface surface(m.surface());
    capsule::surfaceVtk vtk(m.name(), surface, membranes().directions());
    vtk.addVectors("velocity", m.now().velocity);
    vtk.addVectors("force", m.force(surface, surface.areaElement()));

    const capsule::membraneMechanics::principalValues p = m.principal(surface);
    vtk.addScalars("stretch", p.l1);
    vtk.addScalars("tension", p.T1);
    if (surface.axisymmetric())
    {
        vtk.addScalars("hoopStretch", p.l2);
        vtk.addScalars("hoopTension", p.T2);
    }
    else if (surface.spatial())
    {
        vtk.addScalars("secondStretch", p.l2);
        vtk.addScalars("secondTension", p.T2);
    }
    vtk.addScalars("curvature", surface.totalCurvature());
    vtk.write(baseTimeDir(), baseFileDir()/name());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::membraneMeasures::membraneMeasures
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    systemFunction(name, runTime, dict),
    lines_(false)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::membraneMeasures::read(const dictionary& dict)
{
    warnOfOthers(dict, {"lines"});
    lines_ = capsule::input::getOrDefault<bool>(dict, "lines", false);
    return systemFunction::read(dict);
}


bool Foam::functionObjects::membraneMeasures::write()
{
    const capsule::membraneSystem& system = membranes();

    // Walls of all processors
    scalarList gaps(system.nMembranes(), Zero);
    forAll(gaps, i)
    {
        gaps[i] = capsule::meshBoundary::New(mesh_).toWalls
        (
            system[i].surface().sampled()
        );
    }

    if (!Pstream::master())
    {
        return true;
    }

    if (files_.empty())
    {
        files_.setSize(system.nMembranes());
        forAll(files_, i)
        {
            files_.set(i, newFileAtStartTime(system[i].name()));
            writeHead(files_[i], "Membrane " + system[i].name(), columns());
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
