/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membrane.H"
#include "placedShape.H"
#include "sphericalBasis.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
            << "Entry initialStretch of membrane " << name() << " and its"
            << " dictionary reference exclude each other: the reference shape"
            << " gives all stretches" << exit(FatalIOError);
    }
    if (!mechanics_->knowsReference())
    {
        FatalIOErrorInFunction(given)
            << "Membrane " << name() << " has a reference shape, but neither its"
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
        closedSurface(*basis_, placedShape::nodes(*shape, *basis_)), 1
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
            << " of membrane " << name() << " does not depend on the stretch;"
            << " permitted: 1, or no entry" << exit(FatalIOError);
    }
    setReference(initial, stretch, dict);
    if (load_.valid())
    {
        load_->setReference(initial);
    }
    referenceVolume_ = initial.volume();

    history_.now() = interfaceState::atRest
    (
        initial.nodes(), force(initial, initial.areaElement())
    );
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
    directions_(directions),
    history_("membrane", name, directions),
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

    placedShape placed("membrane", name, dict, directions, mesh);
    const membraneShape& shape = placed.shape();
    basis_ = placed.basis();
    mechanics_ = membraneMechanics::New(dict, *basis_);
    if (dict.found("load"))
    {
        load_ = membraneLoad::New(input::subDict(dict, "load"), mesh);
    }

    setInitial(closedSurface(*basis_, placed.nodes()), shape, dict);
    if (!history_.read(dict.topDict(), mesh.time()))
    {
        Info<< "Membrane " << name << ": starts as "
            << placed.description().c_str();
        if (shape.initialStretch() != 1)
        {
            Info<< ", stretched by " << shape.initialStretch();
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
    return dot(force(surface, surface.areaElement()), now().velocity);
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
        closedSurface(*basis_, old(0).x),
        closedSurface(*basis_, old(nOld() - 1).x)
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


// ************************************************************************* //
