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
#include "extrapolatedOutletFvPatchVectorField.H"
#include "basicSymmetryFvPatchFields.H"
#include "transformFvPatchField.H"
#include "fvc.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Largest part of what flows through the boundaries that may be missing: the
//  round-off of values with six digits
static const scalar smallestImbalance = 1e-6;


//- Take new coefficients of the boundary conditions, whatever was done with
//  the old ones: a step may have been refused before it used them
static void update(volVectorField& U)
{
    for (fvPatchVectorField& Up : U.boundaryFieldRef())
    {
        if (Up.updated())
        {
            Up.fvPatchVectorField::evaluate();
        }
    }
    for (fvPatchVectorField& Up : U.boundaryFieldRef())
    {
        Up.updateCoeffs();
    }
}


static void update(volScalarField& p)
{
    for (fvPatchScalarField& pp : p.boundaryFieldRef())
    {
        if (pp.updated())
        {
            pp.fvPatchScalarField::evaluate();
        }
        pp.updateCoeffs();
    }
}


//- What flows in and out through the boundaries of a field, by patch, if it
//  does not balance
static string imbalance(const volVectorField& U)
{
    const fvMesh& mesh = U.mesh();
    DynamicList<word> names;
    DynamicList<scalar> fluxes;
    scalar in = 0;
    scalar out = 0;
    scalar moved = 0;

    for (const fvPatchVectorField& Up : U.boundaryField())
    {
        if (Up.coupled() || Up.patch().type() == "empty")
        {
            continue;
        }
        const vectorField& S = mesh.Sf().boundaryField()[Up.patch().index()];
        const scalarField flux(Up & S);
        in -= sum(min(flux, scalar(0)));
        out += sum(max(flux, scalar(0)));
        moved += sum(mag(Up)*mag(S));
        names.append(Up.patch().name());
        fluxes.append(sum(flux));
    }
    reduce(in, sumOp<scalar>());
    reduce(out, sumOp<scalar>());
    reduce(moved, sumOp<scalar>());

    if
    (
        mag(out - in)
     <= max(smallestImbalance*max(in, out), 1e-10*moved)
    )
    {
        return string::null;
    }
    for (scalar& flux : fluxes)
    {
        reduce(flux, sumOp<scalar>());
    }
    OStringStream message;
    message
        << "the boundaries let in " << in << " and out " << out
        << " m3/s, and no boundary gives the pressure that could balance them;"
        << " out by patch:";
    forAll(names, i)
    {
        message << ' ' << names[i] << ' ' << fluxes[i];
    }
    return message.str();
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::flowEquations::balancedByOutlets() const
{
    for (const fvPatchVectorField& Up : U_.boundaryField())
    {
        if (isA<extrapolatedOutletFvPatchVectorField>(Up))
        {
            return true;
        }
    }
    return false;
}


void Foam::capsule::flowEquations::checkBalance() const
{
    if (!levelFree_ || balancedByOutlets())
    {
        return;
    }
    // On a copy: the first step takes the values of its own time
    volVectorField U
    (
        IOobject
        (
            U_.name(),
            U_.instance(),
            U_.db(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        U_
    );
    update(U);
    const string message = imbalance(U);
    if (!message.empty())
    {
        FatalErrorInFunction
            << "Boundary conditions in " << U_.objectPath() << ": "
            << message.c_str() << nl
            << "    Permitted: velocities whose fluxes sum to zero; an outlet"
            << " that makes up the balance (extrapolatedOutlet); an outlet"
            << " with a given pressure (fixedValue for p with zeroGradient or"
            << " inletOutlet for U)" << exit(FatalError);
    }
}


void Foam::capsule::flowEquations::setSlip(const fvVectorMatrix& UEqn)
{
    slips_.clear();
    forAll(U_.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        if
        (
            !isA<basicSymmetryFvPatchVectorField>(Up)
         || boundaryTypes::aligned(Up.patch())
        )
        {
            continue;
        }
        slip s;
        s.patchi = patchi;
        s.explicitGradient = Up.gradientBoundaryCoeffs();
        s.coefficient.setSize(Up.size());
        const vectorField inner(Up.gradientInternalCoeffs());
        const vectorField& ofMatrix = UEqn.internalCoeffs()[patchi];
        forAll(Up, i)
        {
            s.coefficient[i] = -cmptSum(ofMatrix[i])/cmptSum(inner[i]);
        }
        slips_.append(s);
    }
}


void Foam::capsule::flowEquations::addSlip(vectorField& momentum) const
{
    for (const slip& s : slips_)
    {
        const fvPatchVectorField& Up = U_.boundaryField()[s.patchi];
        const labelUList& cells = Up.patch().faceCells();
        const vectorField change
        (
            Up.gradientBoundaryCoeffs() - s.explicitGradient
        );
        forAll(cells, i)
        {
            momentum[cells[i]] +=
                s.coefficient[i]*change[i]/mesh_.V()[cells[i]];
        }
    }
}


void Foam::capsule::flowEquations::evaluateBoundaries()
{
    for (fvPatchVectorField& Up : U_.boundaryFieldRef())
    {
        Up.fvPatchVectorField::updateCoeffs();
    }
    U_.correctBoundaryConditions();

    for (fvPatchScalarField& pp : p_.boundaryFieldRef())
    {
        pp.fvPatchScalarField::updateCoeffs();
    }
    p_.correctBoundaryConditions();
}


void Foam::capsule::flowEquations::setPressureBoundaries()
{
    update(p_);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

bool Foam::capsule::flowEquations::followsPressure(const label patchi) const
{
    return
        U_.boundaryField()[patchi].assignable()
     && p_.boundaryField()[patchi].fixesValue();
}


Foam::tmp<Foam::vectorField> Foam::capsule::flowEquations::fluxCoeffs
(
    const label patchi
) const
{
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];
    const vectorField& S = mesh_.Sf().boundaryField()[patchi];
    if (followsPressure(patchi))
    {
        return tmp<vectorField>(S);
    }
    if (isA<transformFvPatchField<vector>>(Up))
    {
        // Along the patch: symmetry, slip, wedge
        return tmp<vectorField>(new vectorField(S.size(), Zero));
    }
    return cmptMultiply
    (
        Up.valueInternalCoeffs(mesh_.weights().boundaryField()[patchi]), S
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::flowEquations::setBoundaries()
{
    update(U_);
    unbalanced_ = levelFree_ ? imbalance(U_) : string::null;
}


void Foam::capsule::flowEquations::sayContinuityErrors
(
    const sources* extra
) const
{
    scalarField error(fvc::div(phi_)().primitiveField());
    if (extra)
    {
        error -= extra->divergence.primitiveField();
    }
    const scalarField& V = mesh_.V();
    const scalar perVolume = mesh_.time().deltaTValue()/gSum(V);
    Info<< "Continuity errors: sum local = " << perVolume*gSum(mag(error)*V)
        << ", global = " << perVolume*gSum(error*V) << endl;
}
