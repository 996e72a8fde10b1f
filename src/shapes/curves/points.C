/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "points.H"
#include "segments.H"
#include "IFstream.H"
#include "boundBox.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{
    defineTypeNameAndDebug(points, 0);
    addToRunTimeSelectionTable(curveShape, points, plane);
    addToRunTimeSelectionTable(curveShape, points, wedge);

    //- Distances of this part of the extent of the points are none
    static const scalar same = 1e-9;

    //- Distances of this part of it are the rounding of a file
    static const scalar alike = 1e-6;
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::capsule::shapes::points::readList(Istream& is)
{
    // Before the list, what OpenFOAM's files of points and fields have there
    token t(is);
    while (t.isWord())
    {
        if (t.wordToken() == "FoamFile")
        {
            dictionary header(is);
        }
        is >> t;
    }
    is.putBack(t);
    return pointField(is);
}


void Foam::capsule::shapes::points::setPoints
(
    const pointField& list,
    const solvedDirections& directions,
    const dictionary& dict,
    const fileName& file
)
{
    const boundBox box(list, false);
    const scalar extent = box.mag();
    if (!(cmptMax(cmptMag(box.min())) <= input::largest)
     || !(cmptMax(cmptMag(box.max())) <= input::largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry file " << file << ": coordinates from " << box.min()
            << " to " << box.max() << "; permitted: up to "
            << input::largest << " [m]" << exit(FatalIOError);
    }
    if (mag(box.span() - directions.toVector(directions(box.span()))) > 1e-3*extent)
    {
        FatalIOErrorInFunction(dict)
            << "Entry file " << file << ": the points reach from "
            << box.min() << " to " << box.max() << ", but they must lie in the"
            << " plane of the mesh, whose normal is "
            << (directions.toVector(vector2(1, 0)) ^ directions.toVector(vector2(0, 1)))
            << exit(FatalIOError);
    }

    x_ = directions.toNodes(list);
    const label last = x_.rows() - 1;
    if (last > 0 && (x_.row(last) - x_.row(0)).norm() <= same*extent)
    {
        // The last repeats the first, as in files of closed curves
        x_.conservativeResize(last, 2);
    }
    if (directions.axisymmetric())
    {
        addMirrored(alike*extent);
    }
    const label n = x_.rows();
    if (n < 8)
    {
        FatalIOErrorInFunction(dict)
            << "Entry file " << file << ": " << n << " points, but a curve"
            << " needs at least 8" << exit(FatalIOError);
    }
    check(same*extent, dict, file);

    scalar area = 0;
    for (label i = 0; i < n; ++i)
    {
        area += turn(x_.row(0), x_.row(i), x_.row((i + 1) % n));
    }
    if (area < 0)
    {
        // Clockwise; the first stays the first
        x_.bottomRows(n - 1) =
            nodalVectors(x_.bottomRows(n - 1).colwise().reverse());
    }
    start_ =
        directions.axisymmetric() ? startOnAxis(alike*extent, dict, file) : 0;
}


void Foam::capsule::shapes::points::check
(
    const scalar tolerance,
    const dictionary& dict,
    const fileName& file
) const
{
    const label n = x_.rows();
    for (label i = 0; i < n; ++i)
    {
        const label next = (i + 1) % n;
        const vector2 a = x_.row(i);
        const vector2 b = x_.row(next);
        const vector2 ahead = x_.row((i + 2) % n) - b;
        const scalar length = (b - a).norm();
        if (length <= tolerance)
        {
            FatalIOErrorInFunction(dict)
                << "Entry file " << file << ": points " << i << " and "
                << next << " coincide; they must be distinct"
                << exit(FatalIOError);
        }
        if
        (
            ahead.dot(b - a) < 0
         && mag(turn(a, b, b + ahead)) <= same*length*ahead.norm()
        )
        {
            FatalIOErrorInFunction(dict)
                << "Entry file " << file << ": the curve turns back on itself"
                << " at point " << next << exit(FatalIOError);
        }

        const vector2 low = (a.cwiseMin(b).array() - tolerance).matrix();
        const vector2 high = (a.cwiseMax(b).array() + tolerance).matrix();
        for (label j = i + 2; j < n - (i == 0 ? 1 : 0); ++j)
        {
            const vector2 c = x_.row(j);
            const vector2 d = x_.row((j + 1) % n);
            if
            (
                (c.cwiseMax(d).array() >= low.array()).all()
             && (c.cwiseMin(d).array() <= high.array()).all()
             && squaredDistance(a, b, c, d) <= sqr(tolerance)
            )
            {
                FatalIOErrorInFunction(dict)
                    << "Entry file " << file << ": the segments after points "
                    << i << " and " << j << " cross or touch; the curve must"
                    << " not intersect itself" << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::points::points
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    curveShape(dict, directions, {"file"}),
    start_(0)
{
    const fileName file(fileEntry(dict));
    IFstream is(file);
    if (!is.good())
    {
        FatalIOErrorInFunction(dict)
            << "Entry file: cannot read the points from " << file
            << exit(FatalIOError);
    }
    setPoints
    (
        input::guarded(dict, "file", [&]() { return readList(is); }),
        directions,
        dict,
        file
    );
    const label n = x_.rows();

    s_.setZero(n + 1);
    for (label i = 0; i < n; ++i)
    {
        s_(i + 1) = s_(i) + (x_.row((i + 1) % n) - x_.row(i)).norm();
    }

    // Continuity of the first derivative at each point
    nodalMatrix a = nodalMatrix::Zero(n, n);
    nodalVectors b(n, 2);
    for (label i = 0; i < n; ++i)
    {
        const label before = (i + n - 1) % n;
        const label after = (i + 1) % n;
        const scalar h0 = s_(before + 1) - s_(before);
        const scalar h1 = s_(i + 1) - s_(i);
        a(i, before) = h0/6;
        a(i, i) = (h0 + h1)/3;
        a(i, after) = h1/6;
        b.row(i) =
            (x_.row(after) - x_.row(i))/h1 - (x_.row(i) - x_.row(before))/h0;
    }
    bend_ = a.partialPivLu().solve(b);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::vector2 Foam::capsule::shapes::points::local
(
    const scalar chi
) const
{
    const label n = x_.rows();
    const scalar turns = chi/constant::mathematical::twoPi + start_/s_(n);
    const scalar s = s_(n)*(turns - std::floor(turns));

    const label i =
        std::upper_bound(s_.data() + 1, s_.data() + n, s) - s_.data() - 1;
    const label j = (i + 1) % n;
    const scalar h = s_(i + 1) - s_(i);
    const scalar w1 = (s - s_(i))/h;
    const scalar w0 = 1 - w1;

    return w0*x_.row(i) + w1*x_.row(j)
      + sqr(h)/6*((pow3(w0) - w0)*bend_.row(i) + (pow3(w1) - w1)*bend_.row(j));
}
