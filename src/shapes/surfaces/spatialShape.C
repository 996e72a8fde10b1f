/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "spatialShape.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(spatialShape, 0);
    defineRunTimeSelectionTable(spatialShape, dictionary);

    //- Degree of the harmonics of an outline, and of its grid
    static const label outlineDegree = 24;
}
}

const Foam::scalar Foam::capsule::spatialShape::maxResidual = 0.01;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- The unit vector of an optional entry
static vector unitEntry
(
    const dictionary& dict,
    const word& entry,
    const vector& deflt
)
{
    const vector v(input::getOrDefault<vector>(dict, entry, deflt));
    const scalar length = mag(v);
    if (!(length >= input::smallest && length <= input::largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << v << "; it must be a direction,"
            << " a vector that is not zero" << exit(FatalIOError);
    }
    return v/length;
}


//- The least rotation from z to a unit vector, the one about x to -z
static tensor leastRotation(const vector& axis)
{
    if (axis.z() < -1 + 1e-12)
    {
        return tensor(1, 0, 0, 0, -1, 0, 0, 0, -1);
    }
    // Rodrigues' formula
    const tensor w = *(vector(0, 0, 1) ^ axis);
    return tensor::I + w + (w & w)/(1 + axis.z());
}


//- The rotation from the own axes of a shape
static tensor rotation(const dictionary& dict)
{
    const vector e3 = unitEntry(dict, "axis", vector(0, 0, 1));
    if (!dict.found("direction"))
    {
        return leastRotation(e3);
    }
    const vector direction = unitEntry(dict, "direction", vector(1, 0, 0));
    const vector across = direction - (direction & e3)*e3;
    if (mag(across) < 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "Entry direction is " << direction << ", along the entry axis, "
            << e3 << "; it must have a part across it" << exit(FatalIOError);
    }
    const vector e1 = normalised(across);
    return tensor(e1, e3 ^ e1, e3).T();
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::spatialShape::points
(
    const sphericalGrid& grid
) const
{
    nodalVectors x(grid.size(), 3);
    forAll(grid.nodes(), i)
    {
        x.row(i) =
            centre() + directions_(rotation_ & local(grid.nodes()[i]));
    }
    return x;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::spatialShape::weightedNormals
(
    const sphericalGrid& grid,
    const nodalVectors& coefficients
)
{
    const nodalVectors a = grid.derivative(0)*coefficients;
    const nodalVectors b = grid.derivative(1)*coefficients;
    nodalVectors normals(grid.size(), 3);
    for (label d = 0; d < 3; ++d)
    {
        const label e = (d + 1) % 3;
        const label f = (d + 2) % 3;
        normals.col(d) =
            grid.weights().cwiseProduct
            (
                a.col(e).cwiseProduct(b.col(f))
              - a.col(f).cwiseProduct(b.col(e))
            );
    }
    return normals;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::spatialShape::spatialShape
(
    const dictionary& dict,
    const solvedDirections& directions,
    const wordList& own
)
:
    membraneShape(dict, directions, input::joined({"axis", "direction"}, own)),
    dict_(dict),
    directions_(directions),
    rotation_(rotation(dict))
{}


Foam::autoPtr<Foam::capsule::spatialShape> Foam::capsule::spatialShape::New
(
    const dictionary& dict,
    const solvedDirections& directions
)
{
    return constructor(dict, *dictionaryConstructorTablePtr_, " in space")
    (
        dict, directions
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::spatialShape::residual
(
    const sphericalHarmonics& harmonics,
    const nodalVectors& coefficients
) const
{
    // Along the normal: a shift along the surface does not change the shape
    const sphericalGrid grid(harmonics, harmonics.degree() + 12, 1);
    const nodalVectors normals = weightedNormals(grid, coefficients);
    const nodalScalars areas = normals.rowwise().norm();
    const nodalVectors offset = points(grid) - grid.values()*coefficients;
    const scalar radius =
        std::sqrt(areas.sum()/(4*constant::mathematical::pi));

    return
        dot(offset, normals).cwiseQuotient(areas).cwiseAbs().maxCoeff()/radius;
}


Foam::capsule::nodalVectors Foam::capsule::spatialShape::coefficients
(
    const sphericalHarmonics& harmonics
) const
{
    const sphericalGrid grid(harmonics, harmonics.degree() + 12, 0);
    const nodalVectors result = grid.analysis()*points(grid);
    const scalar distance = residual(harmonics, result);
    if (!(distance <= maxResidual))
    {
        FatalIOErrorInFunction(dict_)
            << "Harmonics of degree " << harmonics.degree() << " come only"
            << " within " << distance << " of its radius of this shape;"
            << " permitted: within " << maxResidual
            << ": raise the degree of the membrane" << exit(FatalIOError);
    }
    return result;
}


void Foam::capsule::spatialShape::outline
(
    nodalVectors& points,
    nodalVectors& normals
) const
{
    const sphericalHarmonics harmonics(outlineDegree);
    const sphericalGrid grid(harmonics, outlineDegree, 1);
    points = this->points(grid);
    normals = weightedNormals(grid, grid.analysis()*points);
}
