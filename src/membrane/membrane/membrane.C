/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membrane.H"
#include "meshBoundary.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::membrane::pointsPerCell = 1.4;

const Foam::scalar Foam::capsule::membrane::widestSpacing = 4;

const Foam::scalar Foam::capsule::membrane::leastAcross = 2;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::membrane::perimeterInCells
(
    const membraneShape& shape,
    const dictionary& dict,
    const fvMesh& mesh,
    const scalar width
) const
{
    const nodalVectors outline = shape.outline();
    const meshBoundary& boundary = meshBoundary::New(mesh);
    const label outside = boundary.firstOutside(outline);
    const word enclosed(outside < 0 ? boundary.enclosed(outline) : word());
    if (outside >= 0 || !enclosed.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Membrane " << name_;
        if (outside >= 0)
        {
            FatalIOError
                << " reaches outside the mesh, to "
                << plane_.toPoint(outline.row(outside));
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

    scalar area = 0;
    scalar perimeter = 0;
    for (label i = 0; i < outline.rows(); ++i)
    {
        const vector2 a = outline.row(i);
        const vector2 b = outline.row((i + 1) % outline.rows());
        area += 0.5*(a(0)*b(1) - a(1)*b(0));
        perimeter += (b - a).norm();
    }

    // Four times the area over the perimeter: the diameter of a circle
    const scalar across = 4*area/max(perimeter, SMALL*width)/width;
    if (!(across >= leastAcross))
    {
        FatalIOErrorInFunction(dict)
            << "Membrane " << name_ << " is " << across << " cells across;"
            << " it needs at least " << leastAcross
            << ": see the entries " << flatOutput(dict.toc())
            << " of shape, or refine the mesh"
            << exit(FatalIOError);
    }
    return perimeter/width;
}


Foam::label Foam::capsule::membrane::nPoints
(
    const dictionary& dict,
    const scalar cells
) const
{
    const label odd = max(label(25), 2*label(0.5*pointsPerCell*cells) + 1);
    const label n = input::getOrDefault<label>
    (
        dict,
        "points",
        plane_.axisymmetric() ? odd + 1 : odd
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
    if (plane_.axisymmetric() && n % 2)
    {
        FatalIOErrorInFunction(dict)
            << "Entry points is " << n << "; for membrane " << name_
            << " in a wedge even numbers from " << least << " to " << most
            << " are permitted: half the points are mirror images"
            << exit(FatalIOError);
    }
    return n;
}


void Foam::capsule::membrane::setInitial
(
    const closedSurface& initial,
    const membraneShape& shape,
    const dictionary& dict
)
{
    const scalar stretch = shape.initialStretch();
    if (stretch != 1 && !mechanics_.law().knowsReference())
    {
        FatalIOErrorInFunction(dict)
            << "Entry initialStretch is " << stretch << ", but the tension of"
            << " the elastic law " << mechanics_.law().type()
            << " of membrane " << name_ << " does not depend on the stretch;"
            << " permitted: 1, or no entry" << exit(FatalIOError);
    }
    mechanics_.setReference(initial, stretch);
    referenceVolume_ = initial.volume();

    now_.x = now_.interface = initial.nodes();
    now_.force = force(initial, initial.areaElement());
    now_.inertia.setZero(size(), 2);
    now_.inner.setZero(size(), 2);
    now_.velocity.setZero(size(), 2);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membrane::membrane
(
    const word& name,
    const dictionary& dict,
    const solvedDirections& plane,
    const fvMesh& mesh
)
:
    name_(name),
    plane_(plane),
    viscosity_
    (
        input::getPositive(dict, "viscosity", dimPressure*dimTime, "Pa s")
    ),
    mechanics_(dict, !plane.axisymmetric())
{
    input::permit
    (
        dict,
        {
            "viscosity",
            "shape",
            "elasticLaw",
            "bending",
            "load",
            "points",
            "levelSet"
        }
    );

    const dictionary& shapeDict = input::subDict(dict, "shape");
    const autoPtr<membraneShape> shape(membraneShape::New(shapeDict, plane));
    const scalar width = gMin(plane.widths(mesh)());
    const label n =
        nPoints(dict, perimeterInCells(*shape, shapeDict, mesh, width));

    basis_ = surfaceBasis::New(plane, n);

    if (dict.found("load"))
    {
        load_ = membraneLoad::New(input::subDict(dict, "load"), mesh);
    }

    const closedSurface initial(*basis_, shape->nodes(*basis_));
    setInitial(initial, *shape, shapeDict);

    if (!readState(dict.topDict(), mesh.time()))
    {
        Info<< "Membrane " << name_ << ": starts as " << shape->type()
            << ", " << n << " points, " << initial.perimeter()/n/width
            << " cell widths apart";
        if (shape->initialStretch() != 1)
        {
            Info<< ", stretched by " << shape->initialStretch();
        }
        Info<< endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::membrane::power
(
    const closedSurface& curve
) const
{
    return dot(force(curve, curve.areaElement()), now_.velocity);
}


Foam::capsule::nodalVectors Foam::capsule::membrane::force
(
    const closedSurface& curve,
    const nodalScalars& areaElement
) const
{
    nodalVectors perParameters = mechanics_.force(curve);
    if (load_.valid())
    {
        perParameters += scaled(curve.areaElement(), load_->force(curve));
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
