/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "analyticalVelocityFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::analyticalVelocityFvPatchVectorField::analyticalVelocityFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF)
{}


Foam::analyticalVelocityFvPatchVectorField::analyticalVelocityFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict)
{}


Foam::analyticalVelocityFvPatchVectorField::analyticalVelocityFvPatchVectorField
(
    const analyticalVelocityFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper)
{}


Foam::analyticalVelocityFvPatchVectorField::analyticalVelocityFvPatchVectorField
(
    const analyticalVelocityFvPatchVectorField& ptf
)
:
    fixedValueFvPatchVectorField(ptf)
{}


Foam::analyticalVelocityFvPatchVectorField::analyticalVelocityFvPatchVectorField
(
    const analyticalVelocityFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::analyticalVelocityFvPatchVectorField::updateCoeffs()
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

    const capsule::solvedDirections directions(mesh);
    const scalar t = db().time().value();
    vectorField& Up = *this;
    forAll(Up, i)
    {
        Up[i] = directions.toVector(exact_->velocity(directions(patch().Cf()[i]), t));
    }
    Up -= gSum(Up & patch().Sf())/gSum(patch().magSf())*patch().nf();

    fixedValueFvPatchVectorField::updateCoeffs();
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchVectorField,
        analyticalVelocityFvPatchVectorField
    );
}
