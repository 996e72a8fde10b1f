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

Foam::Pair<Foam::capsule::faceParts::located> Foam::capsule::faceParts::ends
(
    const label facei
)
{
    const fvMesh& mesh = levelSet_.mesh();
    const face& f = mesh.faces()[facei];
    const Pair<vector2> ends(levelSet_.plane().ends(mesh.points(), f));

    // Known by the lowest point of the mesh there, front or back
    labelPair lowest(labelMax, labelMax);
    for (const label pointi : f)
    {
        const vector2 x = levelSet_.plane()(mesh.points()[pointi]);
        const bool second =
            (x - ends.second()).norm() < (x - ends.first()).norm();
        label& p = second ? lowest.second() : lowest.first();
        p = min(p, pointi);
    }
    const auto find = [&](const vector2& x, const label pointi)
    {
        const auto iter = known_.cfind(pointi);
        if (iter.found())
        {
            return *iter;
        }
        located l{x, 0, 0};
        l.distance = levelSet_.signedDistance(x, l.alpha);
        known_.insert(pointi, l);
        return l;
    };
    return Pair<located>
    (
        find(ends.first(), lowest.first()),
        find(ends.second(), lowest.second())
    );
}


Foam::scalar Foam::capsule::faceParts::crossing
(
    const located& centre,
    const located& end
) const
{
    // Regula falsi with halving (Illinois) on the signed distance
    scalar a = 0, b = 1, fa = centre.distance, fb = end.distance, xi = 0;
    scalar alpha = centre.alpha;
    for (label iter = 0; iter < 30; ++iter)
    {
        xi = (a*fb - b*fa)/(fb - fa);
        const scalar f = levelSet_.signedDistanceFrom
        (
            centre.x + xi*(end.x - centre.x), alpha
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


void Foam::capsule::faceParts::add
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
    scalar alpha = endFar ? end.alpha : centre.alpha;
    for (const scalar gauss : {-1/Foam::sqrt(3.0), 1/Foam::sqrt(3.0)})
    {
        const scalar xi = 0.5*(from + to + gauss*(to - from));
        const vector2 x = centre.x + xi*(end.x - centre.x);
        depths_.append(levelSet_.signedDistanceFrom(x, alpha));
        alphas_.append(alpha);
        parts_.append
        ({
            facei, -length*levelSet_.plane().thickness(x)/area*side
        });
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
    // From the centre to each end at most one crossing is looked for
    const Pair<located> ends(this->ends(facei));
    add(facei, centre, ends.first(), side);
    add(facei, centre, ends.second(), side);
}


// ************************************************************************* //
