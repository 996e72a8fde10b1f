/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "boundaryTypes.H"
#include "fixedGradientFvPatchFields.H"
#include "fixedValueFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"
#include "inletOutletFvPatchFields.H"
#include "slipFvPatchFields.H"
#include "pressureInletOutletVelocityFvPatchVectorField.H"
#include "flowRateInletVelocityFvPatchVectorField.H"
#include "flowRateOutletVelocityFvPatchVectorField.H"
#include "totalPressureFvPatchScalarField.H"
#include "uniformTotalPressureFvPatchScalarField.H"
#include "jumpCyclicFvPatchField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace boundaryTypes
{

//- Types that give values but not what they promise here: they look up fields
//  of other solvers, map values from within the flow, change the mesh, or
//  control the flow from one iteration to the next
static const wordHashSet refusedVelocities
({
    "activeBaffleVelocity", "activePressureForceBaffleVelocity",
    "adjointFarFieldVelocity", "adjointInletVelocity", "adjointOutletVelocity",
    "adjointOutletVelocityFlux", "adjointWallVelocity",
    "adjointWallVelocityLowRe", "externalCoupled",
    "filmHeightInletVelocity", "filmPyrolysisVelocityCoupled", "fixedMean",
    "fixedShearStress", "inclinedFilmNusseltInletVelocity",
    "interstitialInletVelocity", "mapped", "mappedField", "mappedFlowRate",
    "mappedVelocityFlux", "matchedFlowRateOutletVelocity",
    "outletMappedUniformInlet", "outletPhaseMeanVelocity",
    "pressureDirectedInletVelocity", "pressureInletUniformVelocity",
    "pressurePIDControlInletVelocity",
    "semiPermeableBaffleVelocity", "SRFVelocity", "SRFWallVelocity",
    "turbulentDFSEMInlet", "turbulentDigitalFilterInlet", "turbulentInlet",
    "variableHeightFlowRateInletVelocity", "waveVelocity"
});

static const wordHashSet refusedPressures
({
    "buoyantPressure", "electrostaticDeposition", "fanPressure",
    "fixedFluxExtrapolatedPressure", "fixedFluxPressure", "fixedMean",
    "fixedPressureCompressibleDensity", "freeSurfacePressure", "mapped",
    "mappedField", "outletMappedUniformInlet", "plenumPressure",
    "prghPressure", "prghTotalHydrostaticPressure",
    "prghTotalPressure", "rotatingTotalPressure", "syringePressure",
    "turbulentInlet", "uniformDensityHydrostaticPressure",
    "waveSurfacePressure"
});

//- Permitted in words
static const char* const velocities =
    "fixedValue and those derived from it (noSlip, uniformFixedValue,"
    " exprFixedValue, codedFixedValue, flowRateInletVelocity,"
    " flowRateOutletVelocity, ...), extrapolatedOutlet, slip; and with a given"
    " pressure zeroGradient, inletOutlet, pressureInletOutletVelocity,"
    " pressureInletVelocity";

static const char* const pressures =
    "zeroGradient, a given gradient; and at a boundary whose velocity is not"
    " given fixedValue and those derived from it (uniformFixedValue,"
    " exprFixedValue, ...), totalPressure, uniformTotalPressure";


//- Stop at the condition of a patch
template<class Type>
static void refuse
(
    const fvPatchField<Type>& pf,
    const string& why,
    const char* permitted
)
{
    // The pressure that is solved for may be a scaled copy of p
    const char* name = pTraits<Type>::rank ? "U" : "p";
    FatalErrorInFunction
        << "Boundary condition " << pf.type() << " of patch "
        << pf.patch().name() << " in " << pf.internalField().path()/name << ": "
        << why.c_str() << nl << "    Permitted: " << permitted
        << exit(FatalError);
}


//- Are the type and coefficients of a velocity known to be right?
static void checkVelocity(const fvPatchVectorField& Up)
{
    if (isA<fixedValueFvPatchVectorField>(Up))
    {
        if (refusedVelocities.found(Up.type()))
        {
            refuse(Up, "not supported by this solver", velocities);
        }
        return;
    }
    const bool known =
        isType<zeroGradientFvPatchVectorField>(Up)
     || isType<inletOutletFvPatchVectorField>(Up)
     || isType<slipFvPatchVectorField>(Up)
     || isType<pressureInletOutletVelocityFvPatchVectorField>(Up);
    if (!known)
    {
        refuse(Up, "not supported by this solver", velocities);
    }
    if
    (
        isA<pressureInletOutletVelocityFvPatchVectorField>(Up)
     && !aligned(Up.patch())
    )
    {
        refuse
        (
            Up,
            "only on patches perpendicular to an axis; elsewhere inletOutlet,"
            " zeroGradient",
            velocities
        );
    }
}


//- The same of a pressure
static void checkPressure(const fvPatchScalarField& pp)
{
    const bool known =
        isType<zeroGradientFvPatchScalarField>(pp)
     || (
            (
                isA<fixedValueFvPatchScalarField>(pp)
             || isA<fixedGradientFvPatchScalarField>(pp)
            )
         && !refusedPressures.found(pp.type())
        );
    if (!known)
    {
        refuse(pp, "not supported by this solver", pressures);
    }
}


//- Stop at a field that has other dimensions than those of what it is
template<class Field>
static void checkOne
(
    const Field& field,
    const dimensionSet& dimensions,
    const char* what
)
{
    if (field.dimensions() != dimensions)
    {
        FatalErrorInFunction
            << "Field " << field.name() << " in " << field.objectPath()
            << " has the dimensions " << field.dimensions()
            << "; permitted: " << dimensions << " (" << what << ")"
            << exit(FatalError);
    }
}


//- Does a condition look up the density as a field?
static bool needsDensity
(
    const fvPatchVectorField& Up,
    const fvPatchScalarField& pp
)
{
    return
        isA<totalPressureFvPatchScalarField>(pp)
     || isA<uniformTotalPressureFvPatchScalarField>(pp)
     || isA<flowRateInletVelocityFvPatchVectorField>(Up)
     || isA<flowRateOutletVelocityFvPatchVectorField>(Up);
}

} // End namespace boundaryTypes
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::capsule::boundaryTypes::checkDimensions
(
    const volVectorField& U,
    const volScalarField& p,
    const surfaceScalarField& phi
)
{
    checkOne(U, dimVelocity, "U is the velocity in m/s");
    checkOne
    (
        p,
        dimPressure,
        "p is the pressure in Pa; in incompressible solvers of OpenFOAM it is"
        " divided by the density: multiply it by rho"
    );
    checkOne(phi, dimVelocity*dimArea, "phi is the volume flux in m3/s");
}


template<class Type>
bool Foam::capsule::boundaryTypes::constrained(const fvPatchField<Type>& pf)
{
    return
        pf.coupled() || polyPatch::constraintType(pf.patch().patch().type());
}


bool Foam::capsule::boundaryTypes::aligned(const fvPatch& patch)
{
    bool along = true;
    for (const vector& n : vectorField(patch.nf()))
    {
        along = along && cmptMax(cmptMag(n)) > 1 - 1e-10;
    }
    return returnReduce(along, andOp<bool>());
}


void Foam::capsule::boundaryTypes::checkFluxes
(
    const volVectorField& U,
    const volScalarField& p
)
{
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        if (!constrained(Up) && Up.assignable() && !pp.fixesValue())
        {
            refuse
            (
                Up,
                "neither it nor the " + pp.type() + " pressure there gives"
                " what flows through this patch",
                "a given velocity, or extrapolatedOutlet, with a zeroGradient"
                " pressure; or zeroGradient, inletOutlet, ... with a given"
                " pressure"
            );
        }
    }
}


void Foam::capsule::boundaryTypes::checkAffine
(
    const volVectorField& U,
    const volScalarField& p
)
{
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        if (isA<jumpCyclicFvPatchField<scalar>>(pp))
        {
            refuse
            (
                pp,
                "not supported by this solver",
                "cyclic; constant/drivingForce drives a periodic flow"
            );
        }
        if (constrained(Up))
        {
            continue;
        }
        checkVelocity(Up);
        checkPressure(pp);
        if (!Up.assignable() && pp.fixesValue())
        {
            refuse
            (
                pp,
                "it gives the pressure where the " + Up.type() + " velocity is"
                " given too",
                "zeroGradient there, or a velocity that follows the flow"
                " (zeroGradient, inletOutlet, ...)"
            );
        }
    }
}


Foam::autoPtr<Foam::volScalarField> Foam::capsule::boundaryTypes::density
(
    const volVectorField& U,
    const volScalarField& p,
    const dimensionedScalar& rho
)
{
    bool needed = false;
    forAll(U.boundaryField(), patchi)
    {
        needed =
            needed
         || needsDensity(U.boundaryField()[patchi], p.boundaryField()[patchi]);
    }
    autoPtr<volScalarField> field;
    if (needed && !U.db().foundObject<volScalarField>("rho"))
    {
        field.reset
        (
            new volScalarField
            (
                IOobject("rho", U.time().timeName(), U.db()),
                U.mesh(),
                rho
            )
        );
    }
    return field;
}


template bool Foam::capsule::boundaryTypes::constrained
(
    const fvPatchField<scalar>&
);
template bool Foam::capsule::boundaryTypes::constrained
(
    const fvPatchField<vector>&
);
