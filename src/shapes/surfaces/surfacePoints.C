/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfacePoints.H"
#include "sphericalMap.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace shapes
{
    defineTypeNameAndDebug(surfacePoints, 0);
    addToRunTimeSelectionTable(spatialShape, surfacePoints, dictionary);

    //- Points this close, over the radius of the sphere of equal area, need no
    //  higher degree
    static const scalar close = 1e-5;

    //- No middle of a triangle may be farther, over that radius
    static const scalar maxSagitta = 0.05;
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::shapes::surfacePoints::check
(
    const closedTriangulation& surface,
    const dictionary& dict
) const
{
    const scalar radius = surface.radius();
    const vectorField& y = fit_->unitVectors();

    scalar sagitta = 0;
    bool outward = true;
    for (const triFace& t : surface.triangles())
    {
        const point c = t.centre(surface.points());
        const vector foot =
            fit_->foot(c, normalised(y[t[0]] + y[t[1]] + y[t[2]]));
        sagitta = max(sagitta, mag(fit_->position(foot) - c)/radius);
        outward =
            outward
         && (fit_->normal(foot) & t.areaNormal(surface.points())) > 0;
    }
    const scalar distance = fit_->distance()/radius;
    Info<< "Shape of " << fileEntry(dict) << ", " << surface.points().size()
        << " points: harmonics of degree " << fit_->degree() << " pass within "
        << distance << " of its radius" << endl;

    if (!(distance <= maxResidual && sagitta <= maxSagitta && outward))
    {
        FatalIOErrorInFunction(dict)
            << "Entry file " << fileEntry(dict) << ": the smooth surface of"
            << " harmonics of degree " << fit_->degree() << " passes the points"
            << " at up to " << distance << " of the radius (permitted "
            << maxResidual << ") and the middles of triangles at up to "
            << sagitta << " (permitted " << maxSagitta << ")"
            << (outward ? "" : ", and is folded")
            << ": give a smooth surface, not folded sharply, and triangles"
            << " small enough to tell its shape" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::shapes::surfacePoints::surfacePoints
(
    const dictionary& dict,
    const solvedDirections& directions
)
:
    spatialShape(dict, directions, {"file", "scale"})
{
    const closedTriangulation surface
    (
        dict,
        fileEntry(dict),
        input::getBetweenOrDefault<scalar>
        (
            dict, "scale", 1, input::smallest, input::largest
        )
    );
    const sphericalMap map(surface);
    fit_.reset
    (
        new harmonicFit
        (
            surface.points(),
            map.unitVectors(),
            map.parts(),
            close*surface.radius()
        )
    );
    check(surface, dict);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::point Foam::capsule::shapes::surfacePoints::local(const vector& y) const
{
    return fit_->position(y);
}
