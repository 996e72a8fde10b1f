/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "Helfrich.H"
#include "dimensionedScalar.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace bendingModels
{
    defineTypeNameAndDebug(Helfrich, 0);
    addToRunTimeSelectionTable(bendingModel, Helfrich, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::bendingModels::Helfrich::Helfrich(const dictionary& dict)
:
    bendingModel(dict),
    modulus_(dimensionedScalar("bendingModulus", dimEnergy, dict).value())
{
    if (!(modulus_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry bendingModulus is " << modulus_
            << "; it must be positive [J] (for none: type none)"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::bendingModels::Helfrich::setReference
(
    const closedCurve& curve
)
{
    reference_ = curve.curvature();
}


void Foam::capsule::bendingModels::Helfrich::addResultant
(
    const closedCurve& curve,
    nodalVectors& resultant
) const
{
    const nodalScalars moment = modulus_*(curve.curvature() - reference_);
    const nodalScalars shear = curve.ds(moment);
    resultant += scaled(shear, curve.normal());
}


void Foam::capsule::bendingModels::Helfrich::addJacobian
(
    const closedCurve& curve,
    nodalMatrix& jacobian
) const
{
    // Normal displacement w changes the curvature by -w'' to leading order
    const label n = curve.size();
    const nodalMatrix d =
        curve.metric().cwiseInverse().asDiagonal()*curve.basis().derivative();
    const nodalMatrix d2 = d*d;
    const nodalMatrix d4 = -modulus_*(d2*d2);

    for (label i = 0; i < 2; ++i)
    {
        for (label j = 0; j < 2; ++j)
        {
            jacobian.block(i*n, j*n, n, n) +=
                curve.normal().col(i).asDiagonal()*d4
               *curve.normal().col(j).asDiagonal();
        }
    }
}
