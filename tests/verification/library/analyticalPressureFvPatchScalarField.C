/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "analyticalPressureFvPatchScalarField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::analyticalPressureFvPatchScalarField::analyticalPressureFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedGradientFvPatchScalarField(p, iF)
{}


Foam::analyticalPressureFvPatchScalarField::analyticalPressureFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    fixedGradientFvPatchScalarField(p, iF)
{
    if (dict.found("gradient"))
    {
        gradient() = scalarField("gradient", dict, p.size());
    }
    evaluate();
}


Foam::analyticalPressureFvPatchScalarField::analyticalPressureFvPatchScalarField
(
    const analyticalPressureFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedGradientFvPatchScalarField(ptf, p, iF, mapper)
{}


Foam::analyticalPressureFvPatchScalarField::analyticalPressureFvPatchScalarField
(
    const analyticalPressureFvPatchScalarField& ptf
)
:
    fixedGradientFvPatchScalarField(ptf)
{}


Foam::analyticalPressureFvPatchScalarField::analyticalPressureFvPatchScalarField
(
    const analyticalPressureFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedGradientFvPatchScalarField(ptf, iF)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::analyticalPressureFvPatchScalarField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    const fvMesh& mesh = patch().boundaryMesh().mesh();
    if (!exact_.valid())
    {
        exact_ = capsule::analyticalSolution::New(mesh);
    }

    // Central difference over a small part of the distance to the cell
    const capsule::solvedDirections directions(mesh);
    const scalar t = db().time().value();
    const vectorField step(1e-3*patch().nf()/patch().deltaCoeffs());
    const vectorField& centres = patch().Cf();
    scalarField& slope = gradient();
    forAll(slope, i)
    {
        slope[i] =
            (
                exact_->pressure(directions(centres[i] + step[i]), t)
              - exact_->pressure(directions(centres[i] - step[i]), t)
            )
           /(2*mag(step[i]));
    }

    fixedGradientFvPatchScalarField::updateCoeffs();
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchScalarField,
        analyticalPressureFvPatchScalarField
    );
}
