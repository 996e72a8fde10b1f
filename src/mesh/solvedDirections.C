/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.


\*---------------------------------------------------------------------------*/

#include "solvedDirections.H"
#include "wedgeGradients.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "mathematicalConstants.H"
#include "volFields.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void refuseWedge
(
    const Foam::polyBoundaryMesh& patches,
    const Foam::string& why
)
{
    using namespace Foam;

    FatalErrorInFunction
        << "The wedge in " << patches.objectPath() << ' ' << why.c_str()
        << nl << "    A wedge is one cell thick between two patches of type"
        << " wedge, symmetric about a plane of the coordinates, with its"
        << " axis along a direction of the coordinates and the cells at"
        << " greater values of the other one." << exit(FatalError);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::solvedDirections::setPlane(const fvMesh& mesh)
{
    if (mesh.nGeometricD() != 2)
    {
        FatalErrorInFunction
            << "The mesh in " << mesh.boundaryMesh().objectPath() << " has "
            << mesh.nGeometricD() << " solved directions" << nl
            << "    Permitted: two, with two opposite patches of type empty or"
            << " a wedge, two patches of type wedge, or three."
            << exit(FatalError);
    }
    label nEmpty = 0;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        nEmpty += (isA<emptyPolyPatch>(pp) ? pp.size() : 0);
    }
    if (nEmpty != 2*mesh.nCells())
    {
        FatalErrorInFunction
            << "The mesh in " << mesh.boundaryMesh().objectPath() << " has "
            << mesh.nCells() << " cells and " << nEmpty << " faces on patches"
            << " of type empty" << nl
            << "    A plane mesh is one cell thick: two such faces a cell."
            << exit(FatalError);
    }

    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] == -1)
        {
            across_ = d;
        }
    }
    first_ = (across_ == 0 ? 1 : 0);
    second_ = (across_ == 2 ? 1 : 2);

    middle_ = mesh.bounds().midpoint()[across_];
    thickness_ = mesh.bounds().span()[across_];
}


void Foam::capsule::solvedDirections::setWedge(const fvMesh& mesh)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    label nWedge = 0;
    scalar axisAt = -GREAT;
    middle_ = mesh.bounds().midpoint()[0];
    for (const polyPatch& pp : patches)
    {
        if (!isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        const auto& wedge = refCast<const wedgePolyPatch>(pp);
        const vector& axis = wedge.axis();
        const vector& normal = wedge.centreNormal();
        nWedge += wedge.size();
        for (direction d = 0; d < 3; ++d)
        {
            if (mag(axis[d]) > 1 - 1e-6)
            {
                first_ = d;
            }
            if (mag(normal[d]) > 1 - 1e-6)
            {
                across_ = d;
            }
        }
        if (cmptMax(cmptMag(axis)) <= 1 - 1e-6)
        {
            refuseWedge(patches, "has its axis along " + Foam::name(axis));
        }
        second_ = 3 - first_ - across_;
        middle_ = mesh.bounds().midpoint()[across_];
        thickness_ = 2*std::tan(std::acos(wedge.cosAngle()));
        if (wedge.size())
        {
            // Where the plane of the patch meets the middle plane
            const point& c = wedge.faceCentres()[0];
            const vector n = normalised(wedge.faceAreas()[0]);
            axisAt = c[second_] + n[across_]/n[second_]*(c[across_] - middle_);
        }
    }
    axisAt_ = returnReduce(axisAt, maxOp<scalar>());

    if (returnReduce(nWedge != 2*mesh.nCells(), orOp<bool>()))
    {
        refuseWedge(patches, "is not one cell thick");
    }
    const scalar span = mesh.bounds().span()[second_];
    if (mesh.bounds().min()[second_] < axisAt_ - 1e-6*span)
    {
        refuseWedge
        (
            patches, "reaches beyond its axis, or lies at smaller values"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::solvedDirections::solvedDirections(const fvMesh& mesh)
:
    n_(2),
    first_(0),
    second_(1),
    across_(2),
    middle_(0),
    axisymmetric_(false),
    axisAt_(0),
    thickness_(0)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        axisymmetric_ = axisymmetric_ || isA<wedgePolyPatch>(pp);
    }
    if (axisymmetric_)
    {
        setWedge(mesh);
    }
    else if (mesh.nGeometricD() == 3)
    {
        n_ = 3;
        thickness_ = 1;
    }
    else
    {
        setPlane(mesh);
    }
    images_.reset(new periodicImages(mesh, *this));

    // Geometry that is made on demand, which takes all processors: later only
    // those that a membrane cuts would ask for it
    mesh.C();
    mesh.weights();
    mesh.nonOrthDeltaCoeffs();
    if (axisymmetric_)
    {
        wedgeGradients::New(mesh, *this);
    }
}


Foam::capsule::solvedDirections::solvedDirections(const solvedDirections& other)
:
    n_(other.n_),
    first_(other.first_),
    second_(other.second_),
    across_(other.across_),
    middle_(other.middle_),
    axisymmetric_(other.axisymmetric_),
    axisAt_(other.axisAt_),
    thickness_(other.thickness_),
    images_(new periodicImages(*other.images_))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::solvedDirections::sector() const
{
    return
        axisymmetric_
      ? thickness_/constant::mathematical::twoPi
      : thickness_;
}


Foam::tmp<Foam::scalarField> Foam::capsule::solvedDirections::widths
(
    const fvMesh& mesh
) const
{
    if (spatial())
    {
        return Foam::cbrt(mesh.V().field());
    }
    if (!axisymmetric_)
    {
        return Foam::sqrt(mesh.V().field()/thickness_);
    }

    // What the two faces on the wedge cover of its middle plane: the volume is
    // that over a radius which is not the centroid's
    tmp<scalarField> twidths(new scalarField(mesh.nCells(), Zero));
    scalarField& widths = twidths.ref();
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp))
        {
            forAll(pp, i)
            {
                widths[pp.faceCells()[i]] +=
                    0.5*mag(pp.faceAreas()[i][across_]);
            }
        }
    }
    widths = Foam::sqrt(widths);
    return twidths;
}


bool Foam::capsule::solvedDirections::cutsPlane(const polyPatch& pp)
{
    return !isA<emptyPolyPatch>(pp) && !isA<wedgePolyPatch>(pp);
}


Foam::capsule::nodalVectors Foam::capsule::solvedDirections::corners
(
    const pointField& points,
    const face& f
) const
{
    if (spatial())
    {
        nodalVectors result(f.size(), 3);
        forAll(f, i)
        {
            result.row(i) = (*this)(points[f[i]]);
        }
        return result;
    }
    const Pair<vector2> ends(this->ends(points, f));
    nodalVectors result(2, 2);
    result << ends.first(), ends.second();
    return result;
}


Foam::Pair<Foam::capsule::vector2> Foam::capsule::solvedDirections::ends
(
    const pointField& points,
    const face& f
) const
{
    // The other end is the point of the face furthest from the first
    const vector2 a = (*this)(points[f[0]]);
    vector2 b = a;
    for (const label pointi : f)
    {
        const vector2 c = (*this)(points[pointi]);
        if ((c - a).norm() > (b - a).norm())
        {
            b = c;
        }
    }
    return Pair<vector2>(a, b);
}


Foam::pointField Foam::capsule::solvedDirections::toPoints
(
    const nodalVectors& x
) const
{
    pointField result(x.rows());
    forAll(result, i)
    {
        result[i] = toPoint(x.row(i));
    }
    return result;
}


Foam::vectorField Foam::capsule::solvedDirections::toVectors
(
    const nodalVectors& v
) const
{
    vectorField result(v.rows());
    forAll(result, i)
    {
        result[i] = toVector(v.row(i));
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::solvedDirections::toNodes
(
    const vectorField& v
) const
{
    nodalVectors result(v.size(), n_);
    forAll(v, i)
    {
        result.row(i) = (*this)(v[i]);
    }
    return result;
}
