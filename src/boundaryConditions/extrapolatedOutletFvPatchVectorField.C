/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "extrapolatedOutletFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"
#include "surfaceFields.H"
#include "processorFvPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF)
{}


Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict)
{}


Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const extrapolatedOutletFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper)
{}


Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const extrapolatedOutletFvPatchVectorField& ptf
)
:
    fixedValueFvPatchVectorField(ptf)
{}


Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const extrapolatedOutletFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::extrapolatedOutletFvPatchVectorField::followsPressure
(
    const fvPatchVectorField& Up
) const
{
    if (!Up.assignable() || !db().foundObject<volScalarField>("p"))
    {
        return false;
    }
    const auto& p = db().lookupObject<volScalarField>("p");
    return p.boundaryField()[Up.patch().index()].fixesValue();
}


Foam::scalar Foam::extrapolatedOutletFvPatchVectorField::pressureFlux
(
    const fvPatchVectorField& Up
) const
{
    if (db().foundObject<surfaceScalarField>("phi"))
    {
        const auto& phi = db().lookupObject<surfaceScalarField>("phi");
        return sum(phi.boundaryField()[Up.patch().index()]);
    }
    return sum(Up & Up.patch().Sf());
}


Foam::tmp<Foam::vectorField>
Foam::extrapolatedOutletFvPatchVectorField::extrapolated
(
    const volVectorField& field
) const
{
    const fvMesh& mesh = patch().boundaryMesh().mesh();
    const vectorField& U = primitiveField();
    // Not mesh.C(), which all processors would have to ask for at once
    const vectorField& C = mesh.cellCentres();
    tmp<vectorField> tUp(patchInternalField());
    vectorField& Up = tUp.ref();

    forAll(Up, i)
    {
        // The cell beyond, where there is one
        const label facei = patch().start() + i;
        const label celli = patch().faceCells()[i];
        const label opposite =
            mesh.cells()[celli].opposingFaceLabel(facei, mesh.faces());
        if (opposite == -1)
        {
            continue;
        }
        const scalar ahead = mag(patch().Cf()[i] - C[celli]);
        if (mesh.isInternalFace(opposite))
        {
            const label next =
                mesh.owner()[opposite] == celli
              ? mesh.neighbour()[opposite]
              : mesh.owner()[opposite];
            const scalar behind = mag(C[celli] - C[next]);
            Up[i] += ahead/behind*(U[celli] - U[next]);
            continue;
        }
        const label patchi = mesh.boundaryMesh().whichPatch(opposite);
        const fvPatchVectorField& other = field.boundaryField()[patchi];
        if (other.coupled())
        {
            const label j = opposite - other.patch().start();
            const vector next = other.patchNeighbourField()()[j];
            const scalar behind = mag(other.patch().delta()()[j]);
            Up[i] += ahead/behind*(U[celli] - next);
        }
    }
    return tUp;
}


Foam::extrapolatedOutletFvPatchVectorField::fluxes
Foam::extrapolatedOutletFvPatchVectorField::measured
(
    const volVectorField& field,
    UPtrList<fvPatchVectorField>& patches
) const
{
    typedef extrapolatedOutletFvPatchVectorField outlet;

    label n = 0;
    for (const fvPatchVectorField& Up : patches)
    {
        n += !isA<processorFvPatch>(Up.patch());
    }
    fluxes result;
    result.areas.resize(n, Zero);
    result.last.resize(n, Zero);
    result.ahead.resize(n, Zero);
    result.values.resize(n);
    result.rest.resize(2, Zero);

    for (label patchi = 0; patchi < n; ++patchi)
    {
        fvPatchVectorField& Up = patches[patchi];
        const vectorField& S = Up.patch().Sf();
        if (Up.coupled())
        {
            continue;
        }
        if (isA<outlet>(Up))
        {
            result.values.set
            (
                patchi,
                refCast<const outlet>(Up).extrapolated(field).ptr()
            );
            result.areas[patchi] = sum(Up.patch().magSf());
            result.last[patchi] = sum(Up & S);
            result.ahead[patchi] = sum(result.values[patchi] & S);
        }
        else if (followsPressure(Up))
        {
            result.rest[0] += pressureFlux(Up);
            result.rest[1] += sum(Up.patch().magSf());
        }
        else
        {
            Up.updateCoeffs();
            result.rest[0] += sum(Up & S);
        }
    }
    for
    (
        scalarList* list :
        {&result.areas, &result.last, &result.ahead, &result.rest}
    )
    {
        for (scalar& sum : *list)
        {
            reduce(sum, sumOp<scalar>());
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::extrapolatedOutletFvPatchVectorField::updateCoeffs()
{
    typedef extrapolatedOutletFvPatchVectorField outlet;

    if (updated())
    {
        return;
    }

    volVectorField& field =
        db().lookupObjectRef<volVectorField>(internalField().name());
    UPtrList<fvPatchVectorField> patches(field.boundaryField().size());
    forAll(patches, patchi)
    {
        const fvPatchVectorField& Up = field.boundaryField()[patchi];
        patches.set(patchi, const_cast<fvPatchVectorField*>(&Up));
    }

    const fluxes flux(measured(field, patches));
    const scalar area = sum(flux.areas) + flux.rest[1];
    const scalar missing = -sum(flux.last) - flux.rest[0];

    forAll(flux.values, patchi)
    {
        if (flux.values.set(patchi))
        {
            outlet& Up = refCast<outlet>(patches[patchi]);
            const scalar wanted =
                flux.last[patchi] + missing*flux.areas[patchi]/area;
            const scalar shift =
                (wanted - flux.ahead[patchi])/max(flux.areas[patchi], VSMALL);
            Up == flux.values[patchi] + shift*Up.patch().nf();
            Up.fixedValueFvPatchVectorField::updateCoeffs();
        }
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchVectorField,
        extrapolatedOutletFvPatchVectorField
    );
}
