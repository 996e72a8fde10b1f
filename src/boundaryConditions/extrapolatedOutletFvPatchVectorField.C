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

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    curTime_(-GREAT)
{}


Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict),
    curTime_(-GREAT)
{}


Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const extrapolatedOutletFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper),
    curTime_(-GREAT)
{}


Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const extrapolatedOutletFvPatchVectorField& ptf
)
:
    fixedValueFvPatchVectorField(ptf),
    curTime_(ptf.curTime_)
{}


Foam::extrapolatedOutletFvPatchVectorField::extrapolatedOutletFvPatchVectorField
(
    const extrapolatedOutletFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF),
    curTime_(ptf.curTime_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::extrapolatedOutletFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    if (curTime_ != db().time().value())
    {
        const fvMesh& mesh = patch().boundaryMesh().mesh();
        const vectorField& U = primitiveField();
        const volVectorField& field =
            db().lookupObject<volVectorField>(internalField().name());
        // Not mesh.C(), which all processors would have to ask for at once
        const vectorField& C = mesh.cellCentres();
        vectorField& Up = *this;

        forAll(Up, i)
        {
            const label facei = patch().start() + i;
            const label celli = patch().faceCells()[i];
            Up[i] = U[celli];

            // The cell beyond, where there is one
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

        // Flux through all boundaries, of which this patch makes up the rest
        scalar flux = gSum(Up & patch().Sf());
        forAll(field.boundaryField(), patchi)
        {
            const fvPatchVectorField& other = field.boundaryField()[patchi];
            if (patchi != patch().index() && !other.coupled())
            {
                flux += gSum(other & other.patch().Sf());
            }
        }
        Up -= flux/gSum(patch().magSf())*patch().nf();

        curTime_ = db().time().value();
    }

    fixedValueFvPatchVectorField::updateCoeffs();
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
