/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneSystem.H"
#include "timeScheme.H"
#include "fvm.H"
#include "fvc.H"
#include "gaussGrad.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Field>
bool Foam::capsule::membraneSystem::setInside
(
    Field& field,
    scalar (immersedBody::*value)() const
) const
{
    // Those around others go first
    bool changed = false;
    forAll(parts_, i)
    {
        const immersedBody& m = parts_[i];
        const label outer = nesting_.outer(i);
        const scalar inside = (m.*value)();
        if (inside != (outer < 0 ? 1 : (parts_[outer].*value)()))
        {
            changed = true;
            for (const label celli : m.levelSet().inside())
            {
                field[celli] = inside;
            }
        }
    }
    return changed;
}


void Foam::capsule::membraneSystem::setScale()
{
    volScalarField& scale = fields_->scale;
    scale = dimensionedScalar("one", dimless, 1);
    if (setInside(scale, &immersedBody::scale))
    {
        scale.correctBoundaryConditions();
    }
}


void Foam::capsule::membraneSystem::addDriven
(
    volScalarField& pressure,
    const bool inverse
) const
{
    const solvedVector G = directions_(driving_.force());
    forAll(parts_, i)
    {
        const immersedBody& m = parts_[i];
        const label outer = nesting_.outer(i);
        const scalar scales[2] =
            {outer < 0 ? 1 : parts_[outer].scale(), m.scale()};
        const scalar a =
            inverse ? 1/scales[0] - 1/scales[1] : scales[0] - scales[1];
        if (a == 0 || G.isZero(0))
        {
            continue;
        }
        const membraneLevelSet& levelSet = m.levelSet();
        for (const label celli : levelSet.inside())
        {
            pressure[celli] +=
                a*G.dot(levelSet.image(mesh_.C()[celli]) - m.pressureOrigin());
        }
    }
}


void Foam::capsule::membraneSystem::setViscosity()
{
    if (fields_->sources.viscosity.valid())
    {
        volScalarField& mu = *fields_->sources.viscosity;
        mu = dimensionedScalar("mu", mu.dimensions(), mu_);
        for (const immersedBody& m : parts_)
        {
            m.addViscosity(mu);
        }
        mu.correctBoundaryConditions();
    }
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::capsule::membraneSystem::viscousTerm() const
{
    if (fields_.valid() && fields_->sources.viscosity.valid())
    {
        return -fvm::laplacian(*fields_->sources.viscosity, U_);
    }

    const dimensionedScalar mu("mu", dimPressure*dimTime, mu_);
    tmp<fvVectorMatrix> term(-fvm::laplacian(mu, U_));
    bool uniform = true;
    forAll(parts_, i)
    {
        uniform = uniform && parts_[i].viscousScale() == 1;
    }
    if (!uniform)
    {
        scalarField rows(mesh_.nCells(), 1);
        setInside(rows, &immersedBody::viscousScale);
        term.ref() *= volScalarField::Internal
        (
            IOobject("viscousScale", mesh_.time().timeName(), mesh_),
            mesh_,
            dimless,
            rows
        );
    }
    return term;
}


void Foam::capsule::membraneSystem::setFreshCells()
{
    if (timeScheme(mesh_, "ddt(U)", 0).c == 0)
    {
        return;
    }

    volVectorField& freshCells = fields_->freshCells;
    freshCells = dimensionedVector(freshCells.dimensions(), Zero);
    for (const immersedBody& m : parts_)
    {
        m.addFreshCells(freshCells);
    }
    freshCells.primitiveFieldRef() *= rho_*fields_->scale.primitiveField();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::fvVectorMatrix> Foam::capsule::membraneSystem::inertia
(
    tmp<fvVectorMatrix> term,
    const surfaceScalarField& flux
)
{
    if (size())
    {
        flux_.reset(new surfaceScalarField(flux));
        term.ref() -= fvm::Sp(fvc::div(flux), U_);
    }
    if (scaledPressure_.valid())
    {
        term.ref() *= fields_->scale.internalField();
    }
    return term;
}


Foam::volScalarField& Foam::capsule::membraneSystem::scaledPressure()
{
    return scaledPressure_.valid() ? *scaledPressure_ : pressure_;
}


Foam::tmp<Foam::volTensorField>
Foam::capsule::membraneSystem::velocityGradient() const
{
    tmp<volTensorField> gradient
    (
        fv::gaussGrad<vector>::gradf(linearInterpolate(U_), "velocityGradient")
    );
    for (const immersedBody& m : parts_)
    {
        m.addGradient(gradient.ref());
    }
    fv::gaussGrad<vector>::correctBoundaryConditions(U_, gradient.ref());
    return gradient;
}


Foam::tmp<Foam::volScalarField>
Foam::capsule::membraneSystem::viscosity() const
{
    if (fields_.valid() && fields_->sources.viscosity.valid())
    {
        return *fields_->sources.viscosity;
    }

    tmp<volScalarField> viscosity
    (
        volScalarField::New
        (
            "viscosity",
            mesh_,
            dimensionedScalar("one", dimPressure*dimTime, 1),
            zeroGradientFvPatchScalarField::typeName
        )
    );
    setInside(viscosity.ref(), &immersedBody::viscosityRatio);
    viscosity.ref() *= mu_;
    viscosity.ref().correctBoundaryConditions();
    return viscosity;
}


void Foam::capsule::membraneSystem::setInsideOfBodies(surfaceScalarField& phi)
{
    for (label i = nMembranes_; i < parts_.size(); ++i)
    {
        parts_[i].setInside(U_, phi);
    }
}


void Foam::capsule::membraneSystem::setPressure()
{
    if (scaledPressure_.valid())
    {
        volScalarField& p = *scaledPressure_;
        pressure_ = p/fields_->scale;
        for (fvPatchScalarField& pp : pressure_.boundaryFieldRef())
        {
            // Values that are given, maybe in time
            if (pp.fixesValue())
            {
                pp == p.boundaryField()[pp.patch().index()];
            }
        }
        addDriven(pressure_, true);

        // As a restart from here reads it, to the last bit
        p = pressure_*fields_->scale;
        addDriven(p, false);
    }
}
