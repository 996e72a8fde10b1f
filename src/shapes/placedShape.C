/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "placedShape.H"
#include "curveShape.H"
#include "spatialShape.H"
#include "sphericalBasis.H"
#include "meshBoundary.H"
#include "mathematicalConstants.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::placedShape::pointsPerCell = 1.4;

const Foam::scalar Foam::capsule::placedShape::widestSpacing = 4;

const Foam::label Foam::capsule::placedShape::leastDegree = 2;
const Foam::label Foam::capsule::placedShape::greatestDegree = 32;
const Foam::scalar Foam::capsule::placedShape::leastAcross = 2;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::placedShape::radiusInCells
(
    const membraneShape& shape,
    const dictionary& dict,
    const fvMesh& mesh,
    const scalar width
) const
{
    nodalVectors outline;
    nodalVectors normals;
    shape.outline(outline, normals);
    const nodalScalars sizes = normals.rowwise().norm();

    const meshBoundary& boundary = meshBoundary::New(mesh);
    const label outside = boundary.firstOutside(outline);
    const word enclosed
    (
        outside >= 0 ? word()
      : boundary.enclosed
        (
            directions_.spatial()
          ? surfaceSamples(outline, scaled(sizes.cwiseInverse(), normals))
          : surfaceSamples(outline)
        )
    );
    if (outside >= 0 || !enclosed.empty())
    {
        FatalIOErrorInFunction(dict)
            << title_.c_str();
        if (outside >= 0)
        {
            FatalIOError
                << " reaches outside the mesh, to "
                << directions_.toPoint(outline.row(outside));
        }
        else
        {
            FatalIOError
                << " crosses or encloses faces of the patch " << enclosed;
        }
        FatalIOError
            << nl << "    It and all that it encloses must lie inside the mesh,"
            << " which spans " << mesh.bounds().min() << " to "
            << mesh.bounds().max() << "; see the entries "
            << flatOutput(dict.toc()) << " of shape" << exit(FatalIOError);
    }

    // Twice the number of dimensions times what it encloses over its length or
    // area: the diameter of a circle or a sphere
    const scalar size = sizes.sum();
    const scalar across =
        2*dot(outline.rowwise() - outline.colwise().mean(), normals).sum()
       /max(size, VSMALL)/width;
    if (!(across >= leastAcross))
    {
        FatalIOErrorInFunction(dict)
            << title_.c_str() << " is " << across << " cells across;"
            << " it needs at least " << leastAcross
            << ": see the entries " << flatOutput(dict.toc())
            << " of shape, or refine the mesh"
            << exit(FatalIOError);
    }
    const scalar pi = constant::mathematical::pi;
    return
        (directions_.spatial() ? Foam::sqrt(size/(4*pi)) : size/(2*pi))
       /width;
}


Foam::label Foam::capsule::placedShape::nPoints
(
    const dictionary& dict,
    const scalar cells
) const
{
    if (dict.found("degree"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry degree is for surfaces in space; permitted for "
            << called_.c_str() << ": points" << exit(FatalIOError);
    }
    const label odd = max(label(25), 2*label(0.5*pointsPerCell*cells) + 1);
    const label n = input::getOrDefault<label>
    (
        dict,
        "points",
        directions_.axisymmetric() ? odd + 1 : odd
    );

    // Points further apart than four cells do not use what the mesh resolves;
    // points closer than a quarter of a cell only cost
    const label least = max(label(12), label(cells/widestSpacing));
    const label most = max(label(48), label(4*cells) + 1);
    if (n < least || n > most)
    {
        FatalIOErrorInFunction(dict)
            << "Entry points is " << n << "; for " << called_.c_str()
            << " on this mesh, " << least << " to " << most
            << " are permitted: points a quarter of a cell"
            << " width to four cell widths apart" << exit(FatalIOError);
    }
    if (directions_.axisymmetric() && n % 2)
    {
        FatalIOErrorInFunction(dict)
            << "Entry points is " << n << "; for " << called_.c_str()
            << " in a wedge even numbers from " << least << " to " << most
            << " are permitted: half the points are mirror images"
            << exit(FatalIOError);
    }
    return n;
}


Foam::label Foam::capsule::placedShape::degree
(
    const dictionary& dict,
    const scalar cells
) const
{
    if (dict.found("points"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry points is for curves in a plane or a wedge; permitted"
            << " for " << called_.c_str() << ": degree" << exit(FatalIOError);
    }
    if (!dict.found("degree"))
    {
        return max(label(8), min(label(20), label(std::ceil(cells))));
    }
    return input::getBetween<label>
    (
        dict, "degree", leastDegree, greatestDegree
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::placedShape::placedShape
(
    const word& kind,
    const word& name,
    const dictionary& dict,
    const solvedDirections& directions,
    const fvMesh& mesh
)
:
    called_(kind + " " + name),
    title_(called_),
    directions_(directions),
    shape_(membraneShape::New(input::subDict(dict, "shape"), directions))
{
    title_[0] = std::toupper(title_[0]);

    const dictionary& shapeDict = dict.subDict("shape");
    const scalar radius = radiusInCells
    (
        *shape_, shapeDict, mesh, gMin(directions.widths(mesh)())
    );
    OStringStream description;
    description << input::get<word>(shapeDict, "type") << ", ";
    if (directions.spatial())
    {
        const label p = degree(dict, radius);
        basis_.reset(new sphericalBasis(p, (3*p + 1)/2));
        description
            << "degree " << p << ", " << basis_->size() << " nodes, radius "
            << radius << " cell widths";
    }
    else
    {
        const scalar length = constant::mathematical::twoPi*radius;
        const label n = nPoints(dict, length);
        basis_ = surfaceBasis::New(directions_, n);
        description
            << n << " points, " << length/n << " cell widths apart";
    }
    description_ = description.str();
    nodes_ = nodes(*shape_, *basis_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::placedShape::nodes
(
    const membraneShape& shape,
    const surfaceBasis& basis
)
{
    if (!basis.spatial())
    {
        return refCast<const curveShape>(shape).nodes(basis.curve());
    }
    const nodalVectors X = refCast<const spatialShape>(shape).coefficients
    (
        basis.spherical().harmonics()
    );
    return basis.spherical().grid().values().leftCols(X.rows())*X;
}


// ************************************************************************* //
