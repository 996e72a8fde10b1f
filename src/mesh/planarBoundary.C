/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "planarBoundary.H"
#include "segments.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- The side of a face with ends in the plane
static planarBoundary::side sideBetween
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
      ? planarBoundary::side{b, a, width, patchi}
      : planarBoundary::side{a, b, width, patchi};
}


//- A point of a wedge, on its axis if it is there but for round-off: its
//  mirror image leaves no gap
static vector2 snapped
(
    const vector2& x,
    const solvedDirections& directions,
    const scalar width
)
{
    return
        directions.axisymmetric() && mag(directions.radius(x)) < 1e-6*width
      ? vector2(x(0), directions.axisAt())
      : x;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::planarBoundary::encloses(const solvedVector& x) const
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


void Foam::capsule::planarBoundary::nearestHere
(
    const nodalVectors& points,
    nodalScalars& square,
    nodalVectors& feet
) const
{
    const vector2 centre = middle(points);
    const vector2 half =
        0.5*(points.colwise().maxCoeff() - points.colwise().minCoeff());
    const scalar reach = Foam::sqrt(square.maxCoeff());
    for (const side& s : walls_)
    {
        if (!isA<wallPolyPatch>(mesh_.boundaryMesh()[s.patch]))
        {
            continue;
        }
        const vector2 c = 0.5*(s.a + s.b);
        const vector2 shift = directions_.images().image(c, centre) - c;
        const vector2 a = s.a + shift;
        const vector2 b = s.b + shift;
        const vector2 beside = (c + shift - centre).cwiseAbs() - half;
        if (beside.maxCoeff() > reach + 0.5*(b - a).norm())
        {
            continue;
        }
        for (label i = 0; i < points.rows(); ++i)
        {
            const vector2 x = points.row(i);
            const vector2 foot = a + nearestPart(x, a, b)*(b - a);
            const scalar found = (x - foot).squaredNorm();
            if (found < square(i))
            {
                square(i) = found;
                feet.row(i) = foot;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::planarBoundary::planarBoundary(const fvMesh& mesh)
:
    meshBoundary(mesh)
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
            const auto ends = directions_.ends(mesh.points(), pp[i]);
            const scalar width =
                mesh.cellVolumes()[pp.faceCells()[i]]/mag(pp.faceAreas()[i]);
            const vector2 a = snapped(ends.first(), directions_, width);
            const vector2 b = snapped(ends.second(), directions_, width);
            if (directions_.axisymmetric())
            {
                sides.append
                (
                    sideBetween
                    (
                        directions_.mirrored(a), directions_.mirrored(b), width,
                        pp.index()
                    )
                );
            }
            sides.append(sideBetween(a, b, width, pp.index()));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::capsule::planarBoundary::nearest
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
        const vector2 shift = directions_.images().image(c, centre) - c;
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


Foam::scalar Foam::capsule::planarBoundary::toWalls
(
    const nodalVectors& polygon
) const
{
    const label n = polygon.rows();
    const vector2 centre = middle(polygon);
    scalar radius = 0;
    for (label i = 0; i < n; ++i)
    {
        radius = max(radius, (vector2(polygon.row(i)) - centre).norm());
    }

    scalar least = GREAT;
    for (const side& s : walls_)
    {
        if (!isA<wallPolyPatch>(mesh_.boundaryMesh()[s.patch]))
        {
            continue;
        }
        const vector2 c = 0.5*(s.a + s.b);
        const vector2 shift = directions_.images().image(c, centre) - c;

        // Closer than the circle around the polygon it cannot be
        const scalar toCircle =
            (c + shift - centre).norm() - 0.5*(s.b - s.a).norm() - radius;
        if (toCircle > 0 && sqr(toCircle) > least)
        {
            continue;
        }
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
    return leastRoot(least);
}


Foam::word Foam::capsule::planarBoundary::enclosed
(
    const surfaceSamples& surface
) const
{
    const solvedVector centre = middle(surface.points());
    label patchi = -1;
    for (const side& s : walls_)
    {
        if (surface.contains(directions_.images().image(s.a, centre)))
        {
            patchi = max(patchi, s.patch);
        }
    }
    return patchName(patchi);
}
