/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "faceParts.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::capsule::faceParts::located& Foam::capsule::faceParts::corner
(
    const solvedVector& x,
    const label pointi
)
{
    if (!known_.found(pointi))
    {
        known_.insert(pointi, located(levelSet_, x));
    }
    return known_[pointi];
}


Foam::Pair<Foam::capsule::faceParts::located> Foam::capsule::faceParts::ends
(
    const label facei
)
{
    const fvMesh& mesh = levelSet_.mesh();
    const face& f = mesh.faces()[facei];
    const Pair<vector2> ends(levelSet_.directions().ends(mesh.points(), f));

    // Known by the lowest point of the mesh there, front or back
    labelPair lowest(labelMax, labelMax);
    for (const label pointi : f)
    {
        const vector2 x = levelSet_.directions()(mesh.points()[pointi]);
        const bool second =
            (x - ends.second()).norm() < (x - ends.first()).norm();
        label& p = second ? lowest.second() : lowest.first();
        p = min(p, pointi);
    }

    return Pair<located>
    (
        corner(ends.first(), lowest.first()),
        corner(ends.second(), lowest.second())
    );
}


bool Foam::capsule::faceParts::meet
(
    const located& from,
    const located& to,
    scalar& xi
) const
{
    // Newton on x(alpha) = from + xi (to - from)
    const closedSurface& surface = levelSet_.surface();
    const auto cross = [](const vector2& a, const vector2& b)
    {
        return a(0)*b(1) - a(1)*b(0);
    };
    const vector2 start =
        levelSet_.image(levelSet_.directions().toPoint(from.x));
    const vector2 way = to.x - from.x;
    const scalar longest = surface.basis().spacing();
    surfaceParameter at = from.foot;
    xi = from.distance/(from.distance - to.distance);

    for (label iter = 0; iter < 8; ++iter)
    {
        const surfacePoint p = surface.expand(at);
        const vector2 slope = p.first[0];
        const vector2 r = vector2(p.x) - start - xi*way;
        const scalar det = cross(slope, way);
        const scalar step[2] = {-cross(r, way)/det, 0};
        if (!(mag(step[0]) < longest))
        {
            return false;
        }
        const scalar change = cross(slope, r)/det;
        at = surface.basis().moved(at, step);
        xi += change;
        if (mag(change)*way.norm() < 1e-10*levelSet_.width())
        {
            return xi >= 0 && xi <= 1;
        }
    }
    return false;
}


Foam::scalar Foam::capsule::faceParts::crossing
(
    const located& from,
    const located& to
) const
{
    scalar meeting;
    if (meet(from, to, meeting))
    {
        return meeting;
    }

    // Regula falsi with halving (Illinois) on the signed distance
    scalar a = 0, b = 1, fa = from.distance, fb = to.distance, xi = 0;
    surfaceParameter foot = from.foot;

    for (label iter = 0; iter < 30; ++iter)
    {
        xi = (a*fb - b*fa)/(fb - fa);
        const scalar f = levelSet_.signedDistanceFrom
        (
            from.x + xi*(to.x - from.x), foot
        );
        if (mag(f) < 1e-10*levelSet_.width())
        {
            break;
        }
        if (f*fb < 0)
        {
            a = b;
            fa = fb;
        }
        else
        {
            fa *= 0.5;
        }
        b = xi;
        fb = f;
    }
    return xi;
}


void Foam::capsule::faceParts::append
(
    const label facei,
    const scalar weight,
    const solvedVector& x,
    surfaceParameter foot
)
{
    depths_.append(levelSet_.signedDistanceFrom(x, foot));
    feet_.append(foot);
    parts_.append(farSidePart{facei, weight});
}


void Foam::capsule::faceParts::addLine
(
    const label facei,
    const located& centre,
    const located& end,
    const scalar side
)
{
    const bool centreFar = (centre.distance*side < 0);
    const bool endFar = (end.distance*side < 0);
    if (!centreFar && !endFar)
    {
        return;
    }

    scalar from = 0;
    scalar to = 1;
    if (centreFar != endFar)
    {
        (endFar ? from : to) = crossing(centre, end);
    }

    // Two-point Gauss rule, over the thickness of the mesh
    const scalar area = mag(levelSet_.mesh().faceAreas()[facei]);
    const scalar length = 0.5*(to - from)*(end.x - centre.x).norm();
    for (const scalar gauss : {-1/Foam::sqrt(3.0), 1/Foam::sqrt(3.0)})
    {
        const scalar xi = 0.5*(from + to + gauss*(to - from));
        const solvedVector x = centre.x + xi*(end.x - centre.x);
        append
        (
            facei,
            -length*levelSet_.directions().thickness(x)/area*side,
            x,
            endFar ? end.foot : centre.foot
        );
    }
}


void Foam::capsule::faceParts::addTriangle
(
    const label facei,
    const located* corners[3],
    const scalar side
)
{
    // The polygon beyond: corners there, and where the sides are crossed
    solvedVector polygon[4];
    label n = 0;
    surfaceParameter foot(corners[0]->foot);
    for (label i = 0; i < 3; ++i)
    {
        const located& a = *corners[i];
        const located& b = *corners[(i + 1) % 3];
        const bool far = (a.distance*side < 0);
        if (far)
        {
            foot = a.foot;
            polygon[n++] = a.x;
        }
        if (far != (b.distance*side < 0))
        {
            const scalar xi = a.distance/(a.distance - b.distance);
            polygon[n++] = a.x + xi*(b.x - a.x);
        }
    }

    // Triangles about the middle of what has four corners: the two halves of a
    // coupled face go round it in opposite senses, and must agree
    solvedVector middle = polygon[0];
    for (label i = 1; i < n; ++i)
    {
        middle += polygon[i];
    }
    middle /= max(n, label(1));

    const scalar area = mag(levelSet_.mesh().faceAreas()[facei]);
    const solvedDirections& directions = levelSet_.directions();
    for (label i = 0; i < n; ++i)
    {
        const solvedVector& a = polygon[i];
        const solvedVector& b = polygon[(i + 1) % n];
        const vector across =
            directions.toVector(a - middle) ^ directions.toVector(b - middle);
        append
        (
            facei, -0.5*mag(across)/area*side, (middle + a + b)/3, foot
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::faceParts::add
(
    const label facei,
    const located& centre,
    const scalar side
)
{
    // From the centre to each corner, or between two of them, at most one
    // crossing is looked for
    if (!levelSet_.directions().spatial())
    {
        const Pair<located> ends(this->ends(facei));
        addLine(facei, centre, ends.first(), side);
        addLine(facei, centre, ends.second(), side);
        return;
    }

    const fvMesh& mesh = levelSet_.mesh();
    const face& f = mesh.faces()[facei];
    bool far = (centre.distance*side < 0);
    for (const label pointi : f)
    {
        const solvedVector x = levelSet_.directions()(mesh.points()[pointi]);
        far = (corner(x, pointi).distance*side < 0) || far;
    }
    if (!far)
    {
        return;
    }
    forAll(f, i)
    {
        const located* corners[3] =
        {
            &centre, &known_[f[i]], &known_[f[f.fcIndex(i)]]
        };
        addTriangle(facei, corners, side);
    }
}


// ************************************************************************* //
