/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.


\*---------------------------------------------------------------------------*/

#include "membraneVtk.H"
#include "membrane.H"
#include "solvedDirections.H"
#include "OFstream.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A point of the surface: values of a node, or interpolated at an end of the
//  axis, and the angle about the axis
struct Foam::capsule::membraneVtk::station
{
    nodalScalars weights;
    scalar cosine;
    scalar sine;
};


namespace Foam
{
namespace capsule
{

//- Points around the axis
static const label nAround = 48;


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

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::capsule::membraneVtk::turned
(
    const vector2& v,
    const station& s
) const
{
    const vector along = plane_.toVector(vector2(v(0), 0));
    const vector away = plane_.toVector(vector2(0, v(1)));
    const vector axis = plane_.toVector(vector2(1, 0));

    return along + s.cosine*away + s.sine*(axis ^ away);
}


void Foam::capsule::membraneVtk::writePoints
(
    const UList<station>& at,
    Ostream& os
) const
{
    // Turned about the axis
    const vector2 axis(0, plane_.axisymmetric() ? plane_.axisAt() : 0);
    const point origin = plane_.toPoint(axis);
    for (const station& s : at)
    {
        const vector2 x = s.weights.transpose()*x_;
        writeVector(origin + turned(x - axis, s), os);
    }
}


void Foam::capsule::membraneVtk::writeFields
(
    const UList<station>& at,
    Ostream& os
) const
{
    os  << "POINT_DATA " << at.size() << nl;
    const auto writeVectors = [&](const char* name, const nodalVectors& field)
    {
        os  << "VECTORS " << name << " float" << nl;
        for (const station& s : at)
        {
            writeVector(turned(s.weights.transpose()*field, s), os);
        }
    };
    writeVectors("velocity", velocity_);
    writeVectors("force", force_);
    forAll(names_, i)
    {
        os  << "SCALARS " << names_[i] << " float 1" << nl
            << "LOOKUP_TABLE default" << nl;
        for (const station& s : at)
        {
            os  << s.weights.dot(scalars_[i]) << nl;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneVtk::membraneVtk
(
    const membrane& m,
    const solvedDirections& plane
)
:
    membrane_(m),
    plane_(plane),
    curve_(m.curve()),
    velocity_(m.now().velocity),
    force_(m.force(curve_, curve_.areaElement()))
{
    const vector2 centre = curve_.centroid();
    x_ = curve_.nodes().rowwise() + (plane.images().wrapped(centre) - centre);

    const auto add = [&](const char* name, const nodalScalars& field)
    {
        names_.append(name);
        scalars_.append(field);
    };
    add("stretch", m.stretch(curve_));
    add("tension", m.tension(curve_));
    if (curve_.axisymmetric())
    {
        add("hoopStretch", m.secondStretch(curve_));
        add("hoopTension", m.secondTension(curve_));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::membraneVtk::writeLine(const fileName& file) const
{
    const label n = curve_.size();
    List<station> at(n);
    forAll(at, i)
    {
        at[i] = {nodalScalars::Unit(n, i), 1, 0};
    }

    OFstream os(file);
    writeHeader(membrane_.name(), n, os);
    writePoints(at, os);
    os  << "LINES 1 " << n + 2 << nl << n + 1;
    for (label i = 0; i <= n; ++i)
    {
        os  << ' ' << i % n;
    }
    os  << nl;
    writeFields(at, os);
}


void Foam::capsule::membraneVtk::writeSurface(const fileName& file) const
{
    // The two ends of the meridian, then rings of its nodes
    const surfaceBasis& basis = curve_.basis();
    const label n = basis.nPacked();
    List<station> at(2 + n*nAround);
    nodalScalars ends(2);
    ends << -basis.start(), constant::mathematical::pi - basis.start();
    const nodalMatrix atEnds = basis.evaluation(ends);
    at[0] = {atEnds.row(0).transpose(), 1, 0};
    at[1] = {atEnds.row(1).transpose(), 1, 0};
    for (label i = 0; i < n; ++i)
    {
        for (label k = 0; k < nAround; ++k)
        {
            const scalar angle = k*constant::mathematical::twoPi/nAround;
            at[2 + i*nAround + k] =
            {
                nodalScalars::Unit(2*n, i), std::cos(angle), std::sin(angle)
            };
        }
    }

    OFstream os(file);
    writeHeader(membrane_.name(), at.size(), os);
    writePoints(at, os);
    const label nQuads = (n - 1)*nAround;
    os  << "POLYGONS " << nQuads + 2*nAround << ' '
        << 5*nQuads + 4*2*nAround << nl;
    for (label k = 0; k < nAround; ++k)
    {
        const label next = (k + 1) % nAround;
        const auto ring = [&](const label i, const label around)
        {
            return 2 + i*nAround + around;
        };
        os  << "3 0 " << ring(0, k) << ' ' << ring(0, next) << nl
            << "3 1 " << ring(n - 1, next) << ' ' << ring(n - 1, k) << nl;
        for (label i = 0; i + 1 < n; ++i)
        {
            os  << "4 " << ring(i, k) << ' ' << ring(i + 1, k) << ' '
                << ring(i + 1, next) << ' ' << ring(i, next) << nl;
        }
    }
    writeFields(at, os);
}


// ************************************************************************* //
