/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meshBoundary.H"
#include "bitSet.H"
#include "releases.H"
#include "segments.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(meshBoundary, 0);

    //- The side of a face with ends in the plane
    static meshBoundary::side sideBetween
    (
        const vector2& a,
        const vector2& b,
        const scalar width,
        const label patchi
    )
    {
        // Alike, from whichever cell or processor it is seen
        return
            b(1) < a(1)
          ? meshBoundary::side{b, a, width, patchi}
          : meshBoundary::side{a, b, width, patchi};
    }

    //- A point of a wedge, on its axis if it is there but for round-off: its
    //  mirror image leaves no gap
    static vector2 snapped
    (
        const vector2& x,
        const solvedDirections& plane,
        const scalar width
    )
    {
        return
            plane.axisymmetric() && mag(plane.radius(x)) < 1e-6*width
          ? vector2(x(0), plane.axisAt())
          : x;
    }

    //- Middle of the box around points
    static vector2 middle(const nodalVectors& points)
    {
        return 0.5*(points.colwise().minCoeff() + points.colwise().maxCoeff());
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::meshBoundary::encloses(const vector2& x) const
{
    // Crossings of the line from x along the first direction. The same face of
    // two processors, or of both sides of a baffle, crosses it alike
    bool inside = false;
    const auto cross = [&](const side& s)
    {
        if
        (
            (s.a(1) > x(1)) != (s.b(1) > x(1))
         && x(0)
          < s.a(0) + (x(1) - s.a(1))/(s.b(1) - s.a(1))*(s.b(0) - s.a(0))
        )
        {
            inside = !inside;
        }
    };
    for (const side& s : walls_)
    {
        cross(s);
    }
    for (const side& s : coupled_)
    {
        cross(s);
    }
    return inside;
}


bool Foam::capsule::meshBoundary::containsHere(const vector2& x) const
{
    if (plane_.images().periods().empty())
    {
        return encloses(x);
    }
    for (const vector2& image : plane_.images().images(x, plane_.images().wrapped(x)))
    {
        if (encloses(image))
        {
            return true;
        }
    }
    return false;
}


Foam::word Foam::capsule::meshBoundary::patchName(const label patchi) const
{
    const label found = returnReduce(patchi, maxOp<label>());
    return found < 0 ? word() : mesh_.boundaryMesh()[found].name();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::meshBoundary::meshBoundary(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, meshBoundary>(mesh),
    plane_(mesh)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!solvedDirections::cutsPlane(pp))
        {
            continue;
        }
        DynamicList<side>& sides = pp.coupled() ? coupled_ : walls_;
        forAll(pp, i)
        {
            const Pair<vector2> ends(plane_.ends(mesh.points(), pp[i]));
            const scalar width =
                mesh.cellVolumes()[pp.faceCells()[i]]/mag(pp.faceAreas()[i]);
            const vector2 a = snapped(ends.first(), plane_, width);
            const vector2 b = snapped(ends.second(), plane_, width);
            if (plane_.axisymmetric())
            {
                sides.append
                (
                    sideBetween
                    (
                        plane_.mirrored(a), plane_.mirrored(b), width,
                        pp.index()
                    )
                );
            }
            sides.append(sideBetween(a, b, width, pp.index()));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::capsule::meshBoundary::contains(const vector2& x) const
{
    return returnReduce(containsHere(x), orOp<bool>());
}


Foam::label Foam::capsule::meshBoundary::firstOutside
(
    const nodalVectors& points
) const
{
    List<labelList> found(Pstream::nProcs());
    DynamicList<label> mine;
    for (label i = 0; i < points.rows(); ++i)
    {
        if (containsHere(points.row(i)))
        {
            mine.append(i);
        }
    }
    found[Pstream::myProcNo()] = mine;
    allGatherList(found);

    bitSet outside(points.rows(), true);
    for (const labelList& list : found)
    {
        outside.unset(list);
    }
    return outside.find_first();
}


Foam::word Foam::capsule::meshBoundary::nearest
(
    const nodalVectors& polygon,
    const scalar cells
) const
{
    const label n = polygon.rows();
    const vector2 centre = middle(polygon);
    const vector2 half =
        0.5*(polygon.colwise().maxCoeff() - polygon.colwise().minCoeff());

    scalar least = sqr(cells);
    label patchi = -1;
    for (const side& s : walls_)
    {
        const vector2 c = 0.5*(s.a + s.b);
        const vector2 shift = plane_.images().image(c, centre) - c;
        const vector2 a = s.a + shift;
        const vector2 b = s.b + shift;
        const scalar reach = cells*s.width + 0.5*(b - a).norm();
        const vector2 beside = (c + shift - centre).cwiseAbs() - half;
        if (beside(0) > reach || beside(1) > reach)
        {
            continue;
        }
        vector2 x = polygon.row(n - 1);
        for (label i = 0; i < n; ++i)
        {
            const vector2 y = polygon.row(i);
            if
            (
                (0.5*(x + y) - c - shift).norm()
              < reach + 0.5*(y - x).norm()
            )
            {
                const scalar square =
                    squaredDistance(x, y, a, b)/sqr(s.width);
                if (square < least)
                {
                    least = square;
                    patchi = s.patch;
                }
            }
            x = y;
        }
    }

    const scalar found = returnReduce(least, minOp<scalar>());
    return patchName(least == found ? patchi : -1);
}


Foam::scalar Foam::capsule::meshBoundary::toWalls
(
    const nodalVectors& polygon
) const
{
    const label n = polygon.rows();
    const vector2 centre = middle(polygon);
    scalar least = GREAT;
    for (const side& s : walls_)
    {
        if (isA<wallPolyPatch>(mesh_.boundaryMesh()[s.patch]))
        {
            const vector2 c = 0.5*(s.a + s.b);
            const vector2 shift = plane_.images().image(c, centre) - c;
            for (label i = 0; i < n; ++i)
            {
                least = min
                (
                    least,
                    squaredDistance
                    (
                        polygon.row(i), polygon.row((i + 1) % n),
                        s.a + shift, s.b + shift
                    )
                );
            }
        }
    }
    return Foam::sqrt(returnReduce(least, minOp<scalar>()));
}


Foam::word Foam::capsule::meshBoundary::enclosed
(
    const nodalVectors& polygon
) const
{
    const vector2 centre = middle(polygon);
    label patchi = -1;
    for (const side& s : walls_)
    {
        if (inPolygon(plane_.images().image(s.a, centre), polygon))
        {
            patchi = max(patchi, s.patch);
        }
    }
    return patchName(patchi);
}
