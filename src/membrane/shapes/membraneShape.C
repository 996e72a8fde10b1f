/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneShape.H"
#include "unitConversion.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(membraneShape, 0);
    defineRunTimeSelectionTable(membraneShape, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneShape::membraneShape
(
    const dictionary& dict,
    const meshPlane& plane
)
:
    centre_(plane(dict.get<point>("centre"))),
    cos_(std::cos(degToRad(dict.getOrDefault<scalar>("angle", 0)))),
    sin_(std::sin(degToRad(dict.getOrDefault<scalar>("angle", 0))))
{}


Foam::autoPtr<Foam::capsule::membraneShape> Foam::capsule::membraneShape::New
(
    const dictionary& dict,
    const meshPlane& plane
)
{
    const word type(dict.get<word>("type"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "membrane shape",
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }

    return autoPtr<membraneShape>(cstrIter()(dict, plane));
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::scalar Foam::capsule::membraneShape::length
(
    const dictionary& dict,
    const word& entry
)
{
    return dict.getCheck<scalar>(entry, scalarMinMax::ge(VSMALL));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::membraneShape::nodes
(
    const periodicBasis& basis
) const
{
    // A fine trigonometric curve in chi, whose arc length is then inverted:
    // the series of the metric is integrated term by term
    const periodicBasis fine(513);
    nodalVectors x(fine.size(), 2);
    for (label i = 0; i < fine.size(); ++i)
    {
        x.row(i) = local(fine.alpha(i));
    }
    const closedCurve curve(fine, x);
    const nodalScalars g = fine.analysis()*curve.metric();

    const auto arcLength = [&](const scalar chi)
    {
        scalar s = g(0)*chi;
        const nodalScalars f = fine.functions(chi);
        for (label i = 1; i < fine.size(); i += 2)
        {
            const scalar k = (i + 1)/2;
            s += (g(i)*f(i + 1) - g(i + 1)*(f(i) - 1))/k;
        }
        return s;
    };

    nodalVectors result(basis.size(), 2);
    for (label j = 0; j < basis.size(); ++j)
    {
        const scalar target = g(0)*basis.alpha(j);
        scalar chi = basis.alpha(j);
        for (label iter = 0; iter < 50; ++iter)
        {
            const scalar step =
                (arcLength(chi) - target)/fine.functions(chi).dot(g);
            chi -= step;
            if (mag(step) < 1e-13)
            {
                break;
            }
        }
        const vector2 p = local(chi);
        result(j, 0) = centre_(0) + cos_*p(0) - sin_*p(1);
        result(j, 1) = centre_(1) + sin_*p(0) + cos_*p(1);
    }
    return result;
}


Foam::scalar Foam::capsule::membraneShape::perimeter() const
{
    const periodicBasis fine(513);
    return closedCurve(fine, nodes(fine)).perimeter();
}
