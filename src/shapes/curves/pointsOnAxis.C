/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "points.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::shapes::points::addMirrored(const scalar tolerance)
{
    // They are relative to the centre, which is on the axis
    const label n = x_.rows();
    if (n < 2 || x_.col(1).minCoeff() < -tolerance)
    {
        return;
    }
    const label first = (x_(0, 1) <= tolerance ? 1 : 0);
    const label last = n - (x_(n - 1, 1) <= tolerance ? 2 : 1);
    const label more = max(last - first + 1, label(0));

    x_.conservativeResize(n + more, 2);
    for (label i = 0; i < more; ++i)
    {
        x_.row(n + i) << x_(last - i, 0), -x_(last - i, 1);
    }
}


Foam::scalar Foam::capsule::shapes::points::asymmetry(const label sum) const
{
    const label n = x_.rows();
    scalar most = 0;
    for (label i = 0; i < n; ++i)
    {
        const vector2 image = x_.row((sum + n - i) % n);
        most = max
        (
            most,
            mag(image(0) - x_(i, 0)) + mag(image(1) + x_(i, 1))
        );
    }
    return most;
}


Foam::scalar Foam::capsule::shapes::points::startOnAxis
(
    const scalar tolerance,
    const dictionary& dict,
    const fileName& file
)
{
    // A pole is at sum/2, between two points if sum is odd; the other half way
    // round
    const label n = x_.rows();
    const auto at = [&](const label i) -> vector2 { return x_.row(i % n); };
    label sum = 0;
    while (sum < n && !(asymmetry(sum) <= tolerance))
    {
        ++sum;
    }
    if (sum == n)
    {
        FatalIOErrorInFunction(dict)
            << "Entry file " << file << ": the points are not symmetric about"
            << " the axis; permitted in a wedge: a whole outline whose points"
            << " have mirror images within " << tolerance << " [m], or its half"
            << " that is not beyond the axis" << exit(FatalIOError);
    }

    // The half after the pole at the greater coordinate is not beyond the axis
    if (at(sum/2 + 1)(1) < 0)
    {
        sum += n;
    }
    const bool onPoint = (sum % 2 == 0);
    const label first = (sum + 1)/2;
    nodalVectors turnedRound(n, 2);
    for (label i = 0; i < n; ++i)
    {
        turnedRound.row(i) = at(first + i);
    }
    x_ = turnedRound;
    for (label i = (onPoint ? 1 : 0); 2*i < n - (onPoint ? 0 : 1); ++i)
    {
        if (x_(i, 1) <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "Entry file " << file << ": the outline meets the axis at"
                << " more than two places, such as " << x_(i, 0) << " along it"
                << "; permitted in a wedge: two" << exit(FatalIOError);
        }
    }
    return onPoint ? 0 : -0.5*(x_.row(0) - x_.row(n - 1)).norm();
}
