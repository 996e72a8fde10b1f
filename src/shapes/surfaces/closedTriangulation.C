/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "closedTriangulation.H"
#include "input.H"
#include "MeshedSurfaces.H"
#include "releases.H"
#include "boundBox.H"
#include "EdgeMap.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Points closer than this part of the extent are one
static const scalar same = 1e-6;

//- No more triangles than this are taken, for the time of the fit
static const label mostTriangles = 200000;

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::Ostream& Foam::capsule::closedTriangulation::refusal() const
{
    return
        FatalIOErrorInFunction(dict_)
            << "Entry file " << file_ << ": ";
}


void Foam::capsule::closedTriangulation::read(const scalar scale)
{
    if (!isFile(file_))
    {
        refusal() << "there is no such file" << exit(FatalIOError);
    }
    if (!triMeshedSurface::canRead(file_))
    {
        refusal()
            << "surfaces are read by the extension of the file; permitted: "
            << flatOutput(triMeshedSurface::readTypes().sortedToc())
            << exit(FatalIOError);
    }
    const triMeshedSurface surface = input::guarded
    (
        dict_, "file", [&]() { return triMeshedSurface(file_); }
    );
    points_ = scale*surface.points();
    triangles_ = surface.surfFaces();

    for (const triFace& t : triangles_)
    {
        for (const label i : t)
        {
            if (i < 0 || i >= points_.size())
            {
                refusal()
                    << "a triangle has the point " << i << " of "
                    << points_.size() << exit(FatalIOError);
            }
        }
    }
    if (triangles_.size() < 4 || triangles_.size() > mostTriangles)
    {
        refusal()
            << triangles_.size() << " triangles; permitted: 4 to "
            << mostTriangles << exit(FatalIOError);
    }
    for (const point& x : points_)
    {
        if (!(cmptMax(cmptMag(x)) <= input::largest))
        {
            refusal()
                << "a point is " << x << "; permitted: up to "
                << input::largest << " [m]" << exit(FatalIOError);
        }
    }
}


void Foam::capsule::closedTriangulation::weld()
{
    extent_ = boundBox(points_, false).mag();
    if (!(extent_ >= input::smallest))
    {
        refusal()
            << "all points are within " << extent_ << " [m]"
            << exit(FatalIOError);
    }
    labelList merged;
    const label nMerged = coincident(points_, same*extent_, merged);
    pointField points(nMerged);
    forAll(merged, i)
    {
        points[merged[i]] = points_[i];
    }

    labelList kept(nMerged, -1);
    label nPoints = 0;
    label nTriangles = 0;
    for (const triFace& old : triangles_)
    {
        triFace t(merged[old[0]], merged[old[1]], merged[old[2]]);
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        {
            continue;
        }
        for (label& i : t)
        {
            if (kept[i] < 0)
            {
                kept[i] = nPoints++;
            }
            i = kept[i];
        }
        triangles_[nTriangles++] = t;
    }
    triangles_.setSize(nTriangles);
    points_.setSize(nPoints);
    forAll(kept, i)
    {
        if (kept[i] >= 0)
        {
            points_[kept[i]] = points[i];
        }
    }
}


void Foam::capsule::closedTriangulation::setEdges()
{
    EdgeMap<label> edges(2*triangles_.size());
    labelList nAt(3*triangles_.size(), 0);
    edges_.setSize(nAt.size());
    atEdge_.setSize(nAt.size());
    forAll(triangles_, i)
    {
        for (label k = 0; k < 3; ++k)
        {
            const edge e(triangles_[i][k], triangles_[i][(k + 1) % 3]);
            const label n = edges.size();
            if (edges.insert(e, n))
            {
                edges_[n] = e;
            }
            const label at = edges[e];
            if (nAt[at] < 2)
            {
                atEdge_[at][nAt[at]] = i;
            }
            ++nAt[at];
            if (nAt[at] == 2 && edges_[at].start() == e.start())
            {
                refusal()
                    << "the triangles at the edge from "
                    << points_[e.start()] << " to " << points_[e.end()]
                    << " do not have the same side outside"
                    << exit(FatalIOError);
            }
        }
    }
    edges_.setSize(edges.size());
    atEdge_.setSize(edges.size());
    forAll(edges_, i)
    {
        if (nAt[i] != 2)
        {
            refusal()
                << "the edge from " << points_[edges_[i].start()] << " to "
                << points_[edges_[i].end()] << " belongs to " << nAt[i]
                << (nAt[i] == 1 ? " triangle" : " triangles")
                << "; in a closed surface it is two" << exit(FatalIOError);
        }
    }
}


void Foam::capsule::closedTriangulation::checkTopology() const
{
    labelList piece(identity(triangles_.size()));
    const auto root = [&](label i)
    {
        while (piece[i] != i)
        {
            piece[i] = piece[piece[i]];
            i = piece[i];
        }
        return i;
    };
    label nPieces = triangles_.size();
    for (const auto& pair : atEdge_)
    {
        const label a = root(pair[0]);
        const label b = root(pair[1]);
        nPieces -= (a != b);
        piece[a] = b;
    }
    if (nPieces != 1)
    {
        refusal()
            << nPieces << " surfaces; a membrane is one" << exit(FatalIOError);
    }

    const label characteristic =
        points_.size() - edges_.size() + triangles_.size();
    if (characteristic != 2)
    {
        refusal()
            << "the surface has the Euler characteristic " << characteristic
            << ", but that of a membrane, which has no hole through it and"
            << " touches itself nowhere, is 2" << exit(FatalIOError);
    }
}


void Foam::capsule::closedTriangulation::checkVolume() const
{
    scalar volume = 0;
    for (const triFace& t : triangles_)
    {
        volume += (t.centre(points_) - points_[0]) & t.areaNormal(points_)/3;
    }
    if (volume < 0)
    {
        refusal()
            << "the surface is turned inside out: turn the order of the points"
            << " of its triangles, anticlockwise seen from outside"
            << exit(FatalIOError);
    }
    if (!(volume > 1e-9*pow3(extent_)))
    {
        refusal()
            << "the surface encloses " << volume << " [m3] only"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::closedTriangulation::closedTriangulation
(
    const dictionary& dict,
    const fileName& file,
    const scalar scale
)
:
    dict_(dict),
    file_(file),
    extent_(0)
{
    read(scale);
    weld();
    setEdges();
    checkTopology();
    checkFolds();
    checkCrossings();
    checkVolume();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::capsule::closedTriangulation::areas() const
{
    scalarField result(points_.size(), Zero);
    for (const triFace& t : triangles_)
    {
        for (const label i : t)
        {
            result[i] += mag(t.areaNormal(points_))/3;
        }
    }
    return result;
}


Foam::scalar Foam::capsule::closedTriangulation::radius() const
{
    return std::sqrt(sum(areas())/(4*constant::mathematical::pi));
}


Foam::point Foam::capsule::closedTriangulation::centroid() const
{
    // Of tetrahedra with a corner at one of the points
    const point& o = points_[0];
    scalar volume = 0;
    vector moment(Zero);
    for (const triFace& t : triangles_)
    {
        const point c = t.centre(points_);
        const scalar part = (c - o) & t.areaNormal(points_);
        volume += part;
        moment += part*0.75*(c - o);
    }
    return o + moment/volume;
}
