/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membrane.H"
#include "curveShape.H"
#include "spatialShape.H"
#include "sphericalBasis.H"
#include "meshBoundary.H"
#include "mathematicalConstants.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::membrane::pointsPerCell = 1.4;

const Foam::scalar Foam::capsule::membrane::widestSpacing = 4;

const Foam::label Foam::capsule::membrane::leastDegree = 2;
const Foam::label Foam::capsule::membrane::greatestDegree = 32;
const Foam::scalar Foam::capsule::membrane::leastAcross = 2;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The nodes of a basis on a shape
static Foam::capsule::nodalVectors nodesOf
(
    const Foam::capsule::membraneShape& shape,
    const Foam::capsule::surfaceBasis& basis
)
{
    using namespace Foam::capsule;

    if (!basis.spatial())
    {
        return Foam::refCast<const curveShape>(shape).nodes(basis.curve());
    }
    const nodalVectors X =
        Foam::refCast<const spatialShape>(shape).coefficients
        (
            basis.spherical().harmonics()
        );
    return basis.spherical().grid().values().leftCols(X.rows())*X;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::membrane::radiusInCells
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
            << "Membrane " << name_;
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
            << "Membrane " << name_ << " is " << across << " cells across;"
            << " it needs at least " << leastAcross
            << ": see the entries " << flatOutput(dict.toc())
            << " of shape, or refine the mesh"
            << exit(FatalIOError);
    }
    const scalar pi = constant::mathematical::pi;
    return (directions_.spatial() ? Foam::sqrt(size/(4*pi)) : size/(2*pi))/width;
}


Foam::label Foam::capsule::membrane::nPoints
(
    const dictionary& dict,
    const scalar cells
) const
{
    if (dict.found("degree"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry degree is for membranes in space; permitted for membrane "
            << name_ << ": points" << exit(FatalIOError);
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
            << "Entry points is " << n << "; for membrane " << name_
            << " on this mesh, " << least << " to " << most
            << " are permitted: points a quarter of a cell"
            << " width to four cell widths apart" << exit(FatalIOError);
    }
    if (directions_.axisymmetric() && n % 2)
    {
        FatalIOErrorInFunction(dict)
            << "Entry points is " << n << "; for membrane " << name_
            << " in a wedge even numbers from " << least << " to " << most
            << " are permitted: half the points are mirror images"
            << exit(FatalIOError);
    }
    return n;
}


Foam::label Foam::capsule::membrane::degree
(
    const dictionary& dict,
    const scalar cells
) const
{
    if (dict.found("points"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry points is for membranes in a plane or a wedge; permitted"
            << " for membrane " << name_ << ": degree" << exit(FatalIOError);
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


Foam::capsule::nodalVectors Foam::capsule::membrane::setBasis
(
    const membraneShape& shape,
    const dictionary& dict,
    const scalar radius
)
{
    if (!directions_.spatial())
    {
        basis_ = surfaceBasis::New
        (
            directions_, nPoints(dict, constant::mathematical::twoPi*radius)
        );
    }
    else
    {
        const label p = degree(dict, radius);
        basis_.reset(new sphericalBasis(p, (3*p + 1)/2));
    }
    return nodesOf(shape, *basis_);
}


void Foam::capsule::membrane::setReference
(
    const closedSurface& initial,
    const scalar stretch,
    const dictionary& dict
)
{
    if (!dict.found("reference"))
    {
        mechanics_->setReference(initial, stretch);
        return;
    }

    const dictionary& given = input::subDict(dict, "reference");
    if (stretch != 1 || given.found("initialStretch"))
    {
        FatalIOErrorInFunction(given)
            << "Entry initialStretch of membrane " << name_ << " and its"
            << " dictionary reference exclude each other: the reference shape"
            << " gives all stretches" << exit(FatalIOError);
    }
    if (!mechanics_->knowsReference())
    {
        FatalIOErrorInFunction(given)
            << "Membrane " << name_ << " has a reference shape, but neither its"
            << " elastic law, " << mechanics_->law().type()
            << ", nor its bending depend on one; permitted: no entry reference"
            << exit(FatalIOError);
    }
    // Where the reference lies does not matter
    dictionary shapeDict(dict, given);
    if (!given.found("centre"))
    {
        const dictionary& initialDict = input::subDict(dict, "shape");
        shapeDict.add("centre", input::get<point>(initialDict, "centre"));
    }
    const autoPtr<membraneShape> shape(membraneShape::New(shapeDict, directions_));
    mechanics_->setReference
    (
        closedSurface(*basis_, nodesOf(*shape, *basis_)), 1
    );
}


void Foam::capsule::membrane::setInitial
(
    const closedSurface& initial,
    const membraneShape& shape,
    const dictionary& dict
)
{
    const scalar stretch = shape.initialStretch();
    if (stretch != 1 && !mechanics_->law().knowsReference())
    {
        FatalIOErrorInFunction(input::subDict(dict, "shape"))
            << "Entry initialStretch is " << stretch << ", but the tension of"
            << " the elastic law " << mechanics_->law().type()
            << " of membrane " << name_ << " does not depend on the stretch;"
            << " permitted: 1, or no entry" << exit(FatalIOError);
    }
    setReference(initial, stretch, dict);
    if (load_.valid())
    {
        load_->setReference(initial);
    }
    referenceVolume_ = initial.volume();

    now_.x = now_.interface = initial.nodes();
    now_.force = force(initial, initial.areaElement());
    now_.inertia.setZero(size(), directions_.size());
    now_.vorticity.setZero(size(), directions_.size());
    now_.pressure.setZero(size());
    now_.velocity.setZero(size(), directions_.size());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membrane::membrane
(
    const word& name,
    const dictionary& dict,
    const solvedDirections& directions,
    const fvMesh& mesh
)
:
    name_(name),
    directions_(directions),
    viscosity_
    (
        input::getPositive(dict, "viscosity", dimPressure*dimTime, "Pa s")
    )
{
    input::permit
    (
        dict,
        {
            "viscosity",
            "shape",
            "elasticLaw",
            "bending",
            "surfaceViscosity",
            "reference",
            "load",
            "points",
            "degree",
            "levelSet"
        }
    );

    const dictionary& shapeDict = input::subDict(dict, "shape");
    const autoPtr<membraneShape> shape(membraneShape::New(shapeDict, directions));
    const scalar width = gMin(directions.widths(mesh)());
    const scalar radius = radiusInCells(*shape, shapeDict, mesh, width);
    const nodalVectors nodes = setBasis(*shape, dict, radius);
    mechanics_ = membraneMechanics::New(dict, *basis_);
    if (dict.found("load"))
    {
        load_ = membraneLoad::New(input::subDict(dict, "load"), mesh);
    }

    setInitial(closedSurface(*basis_, nodes), *shape, dict);
    if (!readState(dict.topDict(), mesh.time()))
    {
        Info<< "Membrane " << name_ << ": starts as "
            << input::get<word>(shapeDict, "type") << ", ";
        if (basis_->spatial())
        {
            const sphericalBasis& basis = basis_->spherical();
            Info<< "degree " << basis.harmonics().degree() << ", " << size()
                << " nodes, radius " << radius << " cell widths";
        }
        else
        {
            Info<< size() << " points, "
                << constant::mathematical::twoPi*radius/size()
                << " cell widths apart";
        }
        if (shape->initialStretch() != 1)
        {
            Info<< ", stretched by " << shape->initialStretch();
        }
        if (dict.found("reference"))
        {
            Info<< ", from the reference shape "
                << input::get<word>(dict.subDict("reference"), "type");
        }
        Info<< endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::membrane::power
(
    const closedSurface& surface
) const
{
    return dot(force(surface, surface.areaElement()), now_.velocity);
}


void Foam::capsule::membrane::setRates(const timeScheme& scheme)
{
    if (!mechanics_->viscous())
    {
        return;
    }
    if (nOld() == 0)
    {
        mechanics_->setRates(timeScheme(), surface(), surface());
        return;
    }
    mechanics_->setRates
    (
        scheme,
        closedSurface(*basis_, old_[0].x),
        closedSurface(*basis_, old_[nOld() - 1].x)
    );
}


Foam::capsule::nodalVectors Foam::capsule::membrane::force
(
    const closedSurface& surface,
    const nodalScalars& areaElement
) const
{
    nodalVectors perParameters = mechanics_->force(surface);
    if (load_.valid())
    {
        perParameters += scaled(surface.areaElement(), load_->force(surface));
    }
    return areaElement.cwiseInverse().asDiagonal()*perParameters;
}


void Foam::capsule::membrane::store()
{
    old_.setSize(min(old_.size() + 1, label(3)));
    for (label i = old_.size() - 1; i > 0; --i)
    {
        std::swap(old_[i], old_[i - 1]);
    }
    old_[0] = now_;
}


void Foam::capsule::membrane::restore()
{
    std::swap(now_, old_[0]);
    for (label i = 1; i < old_.size(); ++i)
    {
        std::swap(old_[i - 1], old_[i]);
    }
    old_.setSize(old_.size() - 1);
}
