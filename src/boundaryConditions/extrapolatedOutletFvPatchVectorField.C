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
        vectorField& Up = *this;

        forAll(Up, i)
        {
            const label facei = patch().start() + i;
            const label celli = patch().faceCells()[i];
            Up[i] = U[celli];

            // The cell beyond, where there is one on this processor
            const label opposite =
                mesh.cells()[celli].opposingFaceLabel(facei, mesh.faces());
            if (opposite != -1 && mesh.isInternalFace(opposite))
            {
                const label next =
                    mesh.owner()[opposite] == celli
                  ? mesh.neighbour()[opposite]
                  : mesh.owner()[opposite];
                const scalar ahead =
                    mag(patch().Cf()[i] - mesh.C()[celli]);
                const scalar behind = mag(mesh.C()[celli] - mesh.C()[next]);
                Up[i] += ahead/behind*(U[celli] - U[next]);
            }
        }

        // Flux through all boundaries, of which this patch makes up the rest
        scalar flux = gSum(Up & patch().Sf());
        const volVectorField& field =
            db().lookupObject<volVectorField>(internalField().name());
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
