/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowEquations.H"
#include "boundaryTypes.H"
#include "fvc.H"
#include "findRefCell.H"
#include "input.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::flowEquations::setReference(const dictionary& dict)
{
    pRefValue_ = input::getBetween<scalar>
    (
        dict, "pRefValue", -input::largest, input::largest
    );

    if (dict.found("pRefCell"))
    {
        // Of the first processor
        const label last = Pstream::master() ? mesh_.nCells() - 1 : labelMax;
        input::getBetween<label>(dict, "pRefCell", 0, last);
    }
    else if (dict.found("pRefPoint"))
    {
        const point p(input::get<point>(dict, "pRefPoint"));
        if (!mesh_.bounds().contains(p))
        {
            FatalIOErrorInFunction(dict)
                << "Entry pRefPoint is " << p << ", outside the mesh, which"
                << " spans " << mesh_.bounds().min() << " to "
                << mesh_.bounds().max() << exit(FatalIOError);
        }
    }

    setRefCell
    (
        mesh_.lookupObject<volScalarField>("p"),
        p_,
        dict,
        pRefCell_,
        pRefValue_
    );
}


void Foam::capsule::flowEquations::checkHeld() const
{
    bool held = directions_.images().periods().size() < directions_.size();
    for (const fvPatchVectorField& pf : U_.boundaryField())
    {
        held = held || pf.fixesValue();
    }
    if (!held && word(mesh_.ddtScheme("ddt(U)")) == "steadyState")
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "Entry ddt(U) is steadyState, Stokes flow, but the mesh is"
            << " periodic in all directions and no boundary gives the"
            << " velocity: its level is free; permitted here: Euler, backward"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::capsule::flowEquations::set(const fvVectorMatrix& UEqn)
{
    const volScalarField rAU(1.0/UEqn.A());
    rAUf_ = fvc::interpolate(rAU);

    // Both residuals as velocities: h^2/mu times force, h times divergence
    momentumScale_ = rAU.primitiveField();
    continuityScale_ = directions_.widths(mesh_);

    // Pressure over divergence: the reference equation in the same units
    pressureScale_ = gMax(sqr(continuityScale_)/momentumScale_);

    setPressureBoundaries();
    setSlip(UEqn);
}


void Foam::capsule::flowEquations::setBoundaryFlux(const volVectorField& gradp)
{
    forAll(phi_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        if (pp.coupled())
        {
            continue;
        }
        const vectorField& S = mesh_.Sf().boundaryField()[patchi];
        scalarField flux(U_.boundaryField()[patchi] & S);
        if (followsPressure(patchi))
        {
            flux = U_.boundaryField()[patchi].patchInternalField() & S;
            flux +=
                rAUf_.boundaryField()[patchi]
               *(
                    (gradp.boundaryField()[patchi].patchInternalField() & S)
                  - pp.snGrad()*mesh_.magSf().boundaryField()[patchi]
                );
        }
        phi_.boundaryFieldRef()[patchi] = flux;
    }
}


Foam::capsule::nodalScalars Foam::capsule::flowEquations::residual
(
    const fvVectorMatrix& UEqn,
    const sources* extra
)
{
    evaluateBoundaries();

    // Names as in fvSchemes, whichever pressure is solved for
    volVectorField gradp(fvc::grad(p_, "grad(p)"));
    vectorField momentum(-(UEqn & U_)().primitiveField());
    if (extra)
    {
        gradp += extra->gradient;
        gradp.correctBoundaryConditions();
        momentum += extra->momentum;
        if (extra->viscosity.valid())
        {
            momentum +=
                fvc::div(*extra->viscosity*dev2(T(fvc::grad(U_))))()
               .primitiveField();
        }
    }
    momentum -= gradp.primitiveField();
    addSlip(momentum);
    if (force_ != vector(Zero))
    {
        momentum += force_;
    }

    phi_ =
        fvc::flux(U_)
      + rAUf_
       *(
            (fvc::interpolate(gradp) & mesh_.Sf())
          - fvc::snGrad(p_, "snGrad(p)")*mesh_.magSf()
        );
    if (extra)
    {
        phi_ += extra->flux + rAUf_*extra->pressureFlux;
    }

    setBoundaryFlux(gradp);

    scalarField continuity(-fvc::div(phi_)().primitiveField());
    if (extra)
    {
        continuity += extra->divergence.primitiveField();
    }
    if (pRefCell_ != -1)
    {
        // The last equation left over by those of the other cells
        continuity[pRefCell_] =
            (pRefValue_ - p_[pRefCell_])/pressureScale_;
    }

    momentum *= momentumScale_;
    continuity *= continuityScale_;
    return packed(momentum, continuity);
}


Foam::scalar Foam::capsule::flowEquations::termSize() const
{
    return Foam::sqrt
    (
        gSum
        (
            magSqr(U_.primitiveField())
          + magSqr(momentumScale_*p_.primitiveField()/continuityScale_)
        )
    );
}


void Foam::capsule::flowEquations::unscale
(
    const nodalScalars& r,
    vectorField& momentum,
    scalarField& continuity
) const
{
    unpack(r, momentum, continuity);
    momentum /= momentumScale_;
    continuity /= continuityScale_;
}


Foam::capsule::nodalScalars Foam::capsule::flowEquations::packed
(
    const vectorField& U,
    const scalarField& p
) const
{
    const label n = directions_.size();
    nodalScalars x((n + 1)*U.size());
    scalar* unknown = x.data();
    forAll(U, celli)
    {
        for (label i = 0; i < n; ++i)
        {
            *unknown++ = U[celli][directions_.axis(i)];
        }
        *unknown++ = p[celli];
    }
    return x;
}


void Foam::capsule::flowEquations::unpack
(
    const nodalScalars& x,
    vectorField& U,
    scalarField& p
) const
{
    const label n = directions_.size();
    const scalar* unknown = x.data();
    forAll(U, celli)
    {
        U[celli] = Zero;
        for (label i = 0; i < n; ++i)
        {
            U[celli][directions_.axis(i)] = *unknown++;
        }
        p[celli] = *unknown++;
    }
}


void Foam::capsule::flowEquations::unpack(const nodalScalars& x)
{
    unpack(x, U_.primitiveFieldRef(), p_.primitiveFieldRef());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::flowEquations::sources::sources(const fvMesh& mesh)
:
    momentum
    (
        IOobject("interfaceMomentum", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimPressure/dimLength, Zero)
    ),
    gradient
    (
        IOobject("interfaceGradient", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimPressure/dimLength, Zero)
    ),
    flux
    (
        IOobject("interfaceFlux", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimVelocity*dimArea, Zero)
    ),
    pressureFlux
    (
        IOobject("interfacePressureFlux", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimPressure*dimLength, Zero)
    ),
    divergence
    (
        IOobject("interfaceDivergence", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero)
    )
{
    flux.setOriented();
    pressureFlux.setOriented();
}


void Foam::capsule::flowEquations::sources::clear()
{
    momentum = dimensionedVector(momentum.dimensions(), Zero);
    gradient = dimensionedVector(gradient.dimensions(), Zero);
    flux = dimensionedScalar(flux.dimensions(), Zero);
    pressureFlux = dimensionedScalar(pressureFlux.dimensions(), Zero);
    divergence = dimensionedScalar(divergence.dimensions(), Zero);
}


Foam::capsule::flowEquations::flowEquations
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi
)
:
    mesh_(U.mesh()),
    directions_(mesh_),
    U_(U),
    p_(p),
    phi_(phi),
    pRefCell_(-1),
    pRefValue_(0),
    levelFree_(p.needReference()),
    rAUf_
    (
        IOobject("rAUf", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimVelocity*dimLength/dimPressure, Zero)
    ),
    force_(Zero),
    pressureScale_(1)
{
    checkHeld();
    boundaryTypes::checkFluxes(U, p);
    checkBalance();
    if (levelFree_)
    {
        setReference(dict);
    }
}
