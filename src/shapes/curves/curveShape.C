/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "curveShape.H"
#include "unitConversion.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(curveShape, 0);
    defineRunTimeSelectionTable(curveShape, plane);
    defineRunTimeSelectionTable(curveShape, wedge);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::curveShape::setOnAxis
(
    const dictionary& dict,
    const solvedDirections& directions
)
{
    // The axis follows from the patches, with their rounding
    const scalar length =
        (local(0) - local(constant::mathematical::pi)).norm();
    const vector2 onAxis(centre()(0), directions.axisAt());
    if (mag(directions.radius(centre())) > 1e-6*length)
    {
        FatalIOErrorInFunction(dict)
            << "Entry centre is " << input::get<point>(dict, "centre")
            << ", but in a wedge the centre must be on the axis: permitted is "
            << directions.toPoint(onAxis) << exit(FatalIOError);
    }
    moveTo(onAxis);
}


Foam::capsule::vector2 Foam::capsule::curveShape::placed
(
    const vector2& p
) const
{
    return centre() + vector2
    (
        cos_*p(0) - sin_*p(1),
        sin_*p(0) + cos_*p(1)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::curveShape::curveShape
(
    const dictionary& dict,
    const solvedDirections& directions,
    const wordList& own
)
:
    membraneShape(dict, directions, input::joined({"angle", "clustering"}, own)),
    angle_(0),
    cos_(1),
    sin_(0),
    clustering_
    (
        input::getBetweenOrDefault<scalar>(dict, "clustering", 0, -0.8, 0.8)
    )
{
    angle_ = degToRad
    (
        input::getBetweenOrDefault<scalar>(dict, "angle", 0, -360, 360)
    );
    cos_ = std::cos(angle_);
    sin_ = std::sin(angle_);
    if (directions.axisymmetric())
    {
        const scalar degrees = input::getOrDefault<scalar>(dict, "angle", 0);
        if (degrees != 0 && degrees != 180)
        {
            FatalIOErrorInFunction(dict)
                << "Entry angle is " << degrees << "; permitted in a wedge,"
                << " where shapes are of revolution about the axis: 0, 180"
                << exit(FatalIOError);
        }
        cos_ = (degrees == 0 ? 1 : -1);
        sin_ = 0;
    }
}


Foam::autoPtr<Foam::capsule::curveShape> Foam::capsule::curveShape::New
(
    const dictionary& dict,
    const solvedDirections& directions
)
{
    if (!directions.axisymmetric())
    {
        return constructor(dict, *planeConstructorTablePtr_, " in a plane mesh")
        (
            dict, directions
        );
    }

    autoPtr<curveShape> shape
    (
        constructor(dict, *wedgeConstructorTablePtr_, " in a wedge")
        (
            dict, directions
        )
    );
    shape->setOnAxis(dict, directions);
    return shape;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::curveShape::nodes
(
    const curveBasis& basis
) const
{
    // A fine trigonometric curve in chi, whose arc length is then inverted:
    // the series of the metric is integrated term by term
    static const curveBasis fine(513);
    nodalVectors x(fine.size(), 2);
    for (label i = 0; i < fine.size(); ++i)
    {
        x.row(i) = local(fine.alpha(i));
    }
    const closedSurface curve(fine, x);
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

    // In a wedge the curve starts at the pole that the rotation brings first
    const bool revolved = basis.axisymmetric();
    const scalar first = basis.start() + (revolved ? angle_ : 0);

    nodalVectors result(basis.size(), 2);
    for (label j = 0; j < basis.size(); ++j)
    {
        const scalar alpha = first + basis.alpha(j);
        const scalar target = g(0)*(alpha - 0.5*clustering_*std::sin(2*alpha));
        scalar chi = alpha;
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
        result.row(j) = placed(local(chi));
    }
    return basis.symmetric(result);
}


void Foam::capsule::curveShape::outline
(
    nodalVectors& points,
    nodalVectors& normals
) const
{
    const label n = 513;
    points.resize(n, 2);
    for (label i = 0; i < n; ++i)
    {
        points.row(i) = placed(local(i*constant::mathematical::twoPi/n));
    }
    normals.resize(n, 2);
    for (label i = 0; i < n; ++i)
    {
        normals.row(i) = turned(points.row((i + 1) % n) - points.row(i));
    }
}
