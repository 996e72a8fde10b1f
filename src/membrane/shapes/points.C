/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "points.H"
#include "IFstream.H"
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
    addToRunTimeSelectionTable(membraneShape, points, dictionary);

    //- Twice the area of the triangle a, b, c; positive if anticlockwise
    static scalar turn(const vector2& a, const vector2& b, const vector2& c)
    {
        return (b(0) - a(0))*(c(1) - a(1)) - (b(1) - a(1))*(c(0) - a(0));
    }
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::shapes::points::check
(
    const dictionary& dict,
    const fileName& file
) const
{
    const label n = x_.rows();
    scalar area = 0;

    if (!(x_.cwiseAbs().maxCoeff() <= input::largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry file " << file << ": coordinates up to "
            << x_.cwiseAbs().maxCoeff() << "; permitted: up to "
            << input::largest << " [m]" << exit(FatalIOError);
    }

    for (label i = 0; i < n; ++i)
    {
        const vector2 a = x_.row(i);
        const vector2 b = x_.row((i + 1) % n);
        area += turn(vector2::Zero(), a, b);

        if ((a - b).norm() < VSMALL)
        {
            FatalIOErrorInFunction(dict)
                << "Entry file " << file << ": points " << i << " and "
                << (i + 1) % n << " coincide; they must be distinct"
                << exit(FatalIOError);
        }

        for (label j = i + 2; j < n - (i == 0 ? 1 : 0); ++j)
        {
            const vector2 c = x_.row(j);
            const vector2 d = x_.row((j + 1) % n);
            if
            (
                turn(a, b, c)*turn(a, b, d) <= 0
             && turn(c, d, a)*turn(c, d, b) <= 0
            )
            {
                FatalIOErrorInFunction(dict)
                    << "Entry file " << file << ": the segments after points "
                    << i << " and " << j << " cross; the curve must not"
                    << " intersect itself" << exit(FatalIOError);
            }
        }
    }

    if (area <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry file " << file << ": the points are clockwise; they must"
            << " be anticlockwise" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::points::points
(
    const dictionary& dict,
    const meshPlane& plane
)
:
    membraneShape(dict, plane, {"file"})
{
    const string name(input::get<string>(dict, "file").expand());
    if (!string::valid<fileName>(name))
    {
        FatalIOErrorInFunction(dict)
            << "Entry file is " << name << "; it must be the name of a file"
            << exit(FatalIOError);
    }
    const fileName file(name);
    IFstream is(file);
    if (!is.good())
    {
        FatalIOErrorInFunction(dict)
            << "Entry file: cannot read the points from " << file
            << exit(FatalIOError);
    }
    const pointField list
    (
        input::guarded(dict, "file", [&]() { return pointField(is); })
    );
    const label n = list.size();
    if (n < 8)
    {
        FatalIOErrorInFunction(dict)
            << "Entry file " << file << ": " << n << " points, but a curve"
            << " needs at least 8" << exit(FatalIOError);
    }
    x_ = plane.toNodes(list);
    check(dict, file);

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
    const scalar turns = chi/constant::mathematical::twoPi;
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
