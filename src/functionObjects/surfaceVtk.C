/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.


\*---------------------------------------------------------------------------*/

#include "surfaceVtk.H"
#include "solvedDirections.H"
#include "sphericalBasis.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Points around the axis
static const label nAround = 48;

//- Least degree of the grid of a surface in space: the nodes of a smooth one
//  are too few for a picture
static const label pictureDegree = 31;


static void writeHeader
(
    const word& name,
    const label nPoints,
    Ostream& os
)
{
    os  << "# vtk DataFile Version 2.0" << nl << name << nl
        << "ASCII" << nl << "DATASET POLYDATA" << nl
        << "POINTS " << nPoints << " float" << nl;
}


static void writeVector(const vector& v, Ostream& os)
{
    os  << v.x() << ' ' << v.y() << ' ' << v.z() << nl;
}


//- Polygons between rings of points, which come after the two poles
static void writeRings(const label nRings, const label nAround, Ostream& os)
{
    const label nQuads = (nRings - 1)*nAround;
    os  << "POLYGONS " << nQuads + 2*nAround << ' '
        << 5*nQuads + 4*2*nAround << nl;
    const auto ring = [&](const label i, const label around)
    {
        return 2 + i*nAround + around;
    };
    for (label k = 0; k < nAround; ++k)
    {
        const label next = (k + 1) % nAround;
        os  << "3 0 " << ring(0, k) << ' ' << ring(0, next) << nl
            << "3 1 " << ring(nRings - 1, next) << ' '
            << ring(nRings - 1, k) << nl;
        for (label i = 0; i + 1 < nRings; ++i)
        {
            os  << "4 " << ring(i, k) << ' ' << ring(i + 1, k) << ' '
                << ring(i + 1, next) << ' ' << ring(i, next) << nl;
        }
    }
}


//- Write the list of the files of a name in directories of times and of the
//  times, <file>.series
static void writeSeries(const fileName& dir, const fileName& file)
{
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

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::capsule::surfaceVtk::turned
(
    const solvedVector& v,
    const station& s
) const
{
    if (!directions_.axisymmetric())
    {
        return directions_.toVector(v);
    }
    const vector along = directions_.toVector(vector2(v(0), 0));
    const vector away = directions_.toVector(vector2(0, v(1)));
    const vector axis = directions_.toVector(vector2(1, 0));

    return along + s.cosine*away + s.sine*(axis ^ away);
}


void Foam::capsule::surfaceVtk::writePoints
(
    const nodalMatrix& fields,
    const UList<station>& at,
    Ostream& os
) const
{
    // Turned about the axis
    solvedVector axis(solvedVector::Zero(directions_.size()));
    if (directions_.axisymmetric())
    {
        axis(1) = directions_.axisAt();
    }
    const point origin = directions_.toPoint(axis);
    for (const station& s : at)
    {
        solvedVector x(solvedVector::Zero(directions_.size()));
        x += fields.row(s.row).head(directions_.size());
        writeVector(origin + turned(x - axis, s), os);
    }
}


void Foam::capsule::surfaceVtk::writeFields
(
    const nodalMatrix& fields,
    const UList<station>& at,
    Ostream& os
) const
{
    const label d = directions_.size();

    // After the points
    label column = d;
    os  << "POINT_DATA " << at.size() << nl;
    for (const char* name : vectors_)
    {
        os  << "VECTORS " << name << " float" << nl;
        for (const station& s : at)
        {
            writeVector(turned(fields.row(s.row).segment(column, d), s), os);
        }
        column += d;
    }
    for (const char* name : scalars_)
    {
        os  << "SCALARS " << name << " float 1" << nl
            << "LOOKUP_TABLE default" << nl;
        for (const station& s : at)
        {
            os  << fields(s.row, column) << nl;
        }
        ++column;
    }
}


void Foam::capsule::surfaceVtk::writeRevolved(Ostream& os) const
{
    // The two ends of the meridian, then rings of its nodes
    const curveBasis& basis = surface_.basis().curve();
    const label n = basis.nPacked();
    const surfaceParameter first(-basis.start(), 0, 0);
    const surfaceParameter last(pi - basis.start(), 0, 0);
    nodalMatrix fields(2 + n, fields_.cols());
    fields.topRows(2) =
        basis.functions(List<surfaceParameter>{first, last})
       *(basis.analysis()*fields_);
    fields.bottomRows(n) = fields_.topRows(n);

    List<station> at(2 + n*nAround);
    at[0] = station{0, 1, 0};
    at[1] = station{1, 1, 0};
    for (label i = 0; i < n; ++i)
    {
        for (label k = 0; k < nAround; ++k)
        {
            const scalar angle = 2*pi*k/nAround;
            at[2 + i*nAround + k] =
                station{2 + i, std::cos(angle), std::sin(angle)};
        }
    }

    writeHeader(name_, at.size(), os);
    writePoints(fields, at, os);
    writeRings(n, nAround, os);
    writeFields(fields, at, os);
}


void Foam::capsule::surfaceVtk::writeSpatial(Ostream& os) const
{
    // The two poles of the parameter sphere, then a grid's circles around them
    const sphericalBasis& basis = surface_.basis().spherical();
    const sphericalGrid grid
    (
        sphericalHarmonics(0), max(basis.grid().degree(), pictureDegree), 0
    );
    List<surfaceParameter> parameters(2 + grid.size());
    parameters[0] = vector(0, 0, 1);
    parameters[1] = vector(0, 0, -1);
    List<station> at(parameters.size(), station{0, 1, 0});
    forAll(at, i)
    {
        at[i].row = i;
        if (i > 1)
        {
            parameters[i] = grid.nodes()[i - 2];
        }
    }
    const nodalMatrix fields =
        basis.functions(parameters)*(basis.analysis()*fields_);

    writeHeader(name_, at.size(), os);
    writePoints(fields, at, os);
    writeRings(grid.degree() + 1, 2*grid.degree() + 2, os);
    writeFields(fields, at, os);
}


void Foam::capsule::surfaceVtk::writeLine(const fileName& file) const
{
    const label n = surface_.size();
    List<station> at(n, station{0, 1, 0});
    forAll(at, i)
    {
        at[i].row = i;
    }

    OFstream os(file);
    writeHeader(name_, n, os);
    writePoints(fields_, at, os);
    os  << "LINES 1 " << n + 2 << nl << n + 1;
    for (label i = 0; i <= n; ++i)
    {
        os  << ' ' << i % n;
    }
    os  << nl;
    writeFields(fields_, at, os);
}


void Foam::capsule::surfaceVtk::writeSurface(const fileName& file) const
{
    OFstream os(file);
    if (directions_.spatial())
    {
        writeSpatial(os);
    }
    else
    {
        writeRevolved(os);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surfaceVtk::surfaceVtk
(
    const word& name,
    const closedSurface& surface,
    const solvedDirections& directions
)
:
    name_(name),
    directions_(directions),
    surface_(surface)
{
    const solvedVector centre = surface_.centroid();
    fields_ =
        surface_.nodes().rowwise()
      + (directions.images().wrapped(centre) - centre);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::surfaceVtk::addVectors
(
    const char* name,
    const nodalVectors& v
)
{
    vectors_.append(name);
    fields_.conservativeResize(v.rows(), fields_.cols() + v.cols());
    fields_.rightCols(v.cols()) = v;
}


void Foam::capsule::surfaceVtk::addScalars
(
    const char* name,
    const nodalScalars& f
)
{
    scalars_.append(name);
    fields_.conservativeResize(f.rows(), fields_.cols() + 1);
    fields_.rightCols(1) = f;
}


void Foam::capsule::surfaceVtk::write
(
    const fileName& timeDir,
    const fileName& dir
) const
{
    mkDir(timeDir);
    if (!directions_.spatial())
    {
        writeLine(timeDir/name_ + ".vtk");
        writeSeries(dir, name_ + ".vtk");
    }
    if (directions_.axisymmetric() || directions_.spatial())
    {
        writeSurface(timeDir/name_ + ".surface.vtk");
        writeSeries(dir, name_ + ".surface.vtk");
    }
}


// ************************************************************************* //
