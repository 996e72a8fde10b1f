/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "scaledFluid.H"
#include "timeScheme.H"
#include "fvm.H"
#include "fvc.H"
#include "gaussGrad.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::scaledFluid::around
(
    const immersedBody& m,
    bodyValue value
)
{
    return m.outer() ? (m.outer()->*value)() : 1;
}


template<class Field>
bool Foam::capsule::scaledFluid::setInside(Field& field, bodyValue value) const
{
    // Those around others go first
    bool changed = false;
    for (const immersedBody& m : parts_)
    {
        const scalar inside = (m.*value)();
        if (inside != around(m, value))
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


void Foam::capsule::scaledFluid::addDriven
(
    volScalarField& pressure,
    const bool inverse
) const
{
    const solvedVector G = directions_(driving_.force());
    for (const immersedBody& m : parts_)
    {
        const scalar scales[2] =
            {around(m, &immersedBody::scale), m.scale()};
        const scalar a =
            inverse ? 1/scales[0] - 1/scales[1] : scales[0] - scales[1];
        if (a == 0 || G.isZero(0))
        {
            continue;
        }
        const membraneLevelSet& levelSet = m.levelSet();
        const volVectorField& C = U_.mesh().C();
        for (const label celli : levelSet.inside())
        {
            pressure[celli] +=
                a*G.dot(levelSet.image(C[celli]) - m.pressureOrigin());
        }
    }
}


void Foam::capsule::scaledFluid::setViscosity()
{
    if (smeared())
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


void Foam::capsule::scaledFluid::setFreshCells()
{
    if (timeScheme(U_.mesh(), "ddt(U)", 0).c == 0)
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::scaledFluid::scaledFluid
(
    PtrList<immersedBody>& parts,
    const solvedDirections& directions,
    volVectorField& U,
    volScalarField& pressure,
    const scalar density,
    const scalar viscosity,
    const drivingForce& driving
)
:
    parts_(parts),
    directions_(directions),
    U_(U),
    pressure_(pressure),
    rho_(density),
    mu_(viscosity),
    driving_(driving)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volTensorField>
Foam::capsule::scaledFluid::velocityGradient() const
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
Foam::capsule::scaledFluid::viscosity() const
{
    if (smeared())
    {
        return *fields_->sources.viscosity;
    }

    tmp<volScalarField> viscosity
    (
        volScalarField::New
        (
            "viscosity",
            U_.mesh(),
            dimensionedScalar("one", dimPressure*dimTime, 1),
            zeroGradientFvPatchScalarField::typeName
        )
    );
    setInside(viscosity.ref(), &immersedBody::viscosityRatio);
    viscosity.ref() *= mu_;
    viscosity.ref().correctBoundaryConditions();
    return viscosity;
}


void Foam::capsule::scaledFluid::start()
{
    if (parts_.empty())
    {
        return;
    }
    const fvMesh& mesh = U_.mesh();
    fields_.reset(new scaledFields(mesh));
    bool scaled = false;
    for (const immersedBody& m : parts_)
    {
        scaled = scaled || m.scale() != 1;
        if (m.smeared())
        {
            fields_->sources.viscosity.reset
            (
                new volScalarField
                (
                    IOobject("viscosity", mesh.time().timeName(), mesh),
                    mesh,
                    dimensionedScalar(dimPressure*dimTime, Zero)
                )
            );
        }
    }
    setScale();
    if (scaled)
    {
        scaledPressure_.reset(new volScalarField("pScaled", pressure_));
        *scaledPressure_ *= fields_->scale;
        addDriven(*scaledPressure_, false);
    }
}


void Foam::capsule::scaledFluid::setScale()
{
    volScalarField& scale = fields_->scale;
    scale = dimensionedScalar("one", dimless, 1);
    if (setInside(scale, &immersedBody::scale))
    {
        scale.correctBoundaryConditions();
    }
}


void Foam::capsule::scaledFluid::setStep()
{
    setScale();
    setViscosity();
    setFreshCells();
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::capsule::scaledFluid::viscousTerm() const
{
    if (smeared())
    {
        return -fvm::laplacian(*fields_->sources.viscosity, U_);
    }

    const fvMesh& mesh = U_.mesh();
    const dimensionedScalar mu("mu", dimPressure*dimTime, mu_);
    tmp<fvVectorMatrix> term(-fvm::laplacian(mu, U_));
    bool uniform = true;
    for (const immersedBody& m : parts_)
    {
        uniform = uniform && m.viscousScale() == 1;
    }
    if (!uniform)
    {
        scalarField rows(mesh.nCells(), 1);
        setInside(rows, &immersedBody::viscousScale);
        term.ref() *= volScalarField::Internal
        (
            IOobject("viscousScale", mesh.time().timeName(), mesh),
            mesh,
            dimless,
            rows
        );
    }
    return term;
}


Foam::tmp<Foam::fvVectorMatrix> Foam::capsule::scaledFluid::inertia
(
    tmp<fvVectorMatrix> term,
    const surfaceScalarField& flux
)
{
    if (parts_.size())
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


void Foam::capsule::scaledFluid::setSources()
{
    flowEquations::sources& sources = fields_->sources;
    sources.clear();
    for (immersedBody& m : parts_)
    {
        m.addSources(sources, flux_.get(), fields_->scale);
    }
    sources.momentum += fields_->freshCells;
}


void Foam::capsule::scaledFluid::setPressure()
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
