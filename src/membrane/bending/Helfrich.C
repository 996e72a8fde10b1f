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
    modulus_(input::getPositive(dict, "bendingModulus", dimEnergy, "J")),
    initial_(true),
    uniform_(0)
{
    const word entry("referenceCurvature");
    if (!dict.found(entry))
    {
        return;
    }
    const token first = input::guarded
    (
        dict,
        entry,
        [&]() { return token(dict.lookup(entry)); }
    );
    if (first.isWord())
    {
        const word choice(input::get<word>(dict, entry));
        initial_ = (choice == "initial");
        if (!initial_ && choice != "none")
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << entry << " is " << choice << "; permitted:"
                << " initial, none, or a curvature [1/m]" << exit(FatalIOError);
        }
        return;
    }

    initial_ = false;
    uniform_ = input::guarded
    (
        dict,
        entry,
        [&]()
        {
            return
                dimensionedScalar(entry, dimless/dimLength, dict).value();
        }
    );
    if (!(mag(uniform_) <= input::largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << uniform_ << "; its magnitude may"
            << " be up to " << input::largest << " [1/m]" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::bendingModels::Helfrich::setReference
(
    const closedSurface& curve
)
{
    reference_ =
        initial_
      ? curve.curvature()
      : nodalScalars::Constant(curve.size(), uniform_);
}


void Foam::capsule::bendingModels::Helfrich::addResultant
(
    const closedSurface& curve,
    nodalVectors& resultant
) const
{
    const nodalScalars moment = modulus_*(curve.curvature() - reference_);
    const nodalScalars shear = curve.ds(moment);
    resultant += scaled(shear, curve.normal());
}


void Foam::capsule::bendingModels::Helfrich::addJacobian
(
    const closedSurface& curve,
    nodalMatrix& jacobian
) const
{
    // With x' = dx/dalpha, g = |x'|, kappa = x' x x''/g^3:
    //     dg = t.dx',  dn = -t (n.dx')/g
    //     dkappa = (dx' x x'' + x' x dx'')/g^3 - 3 kappa dg/g
    //     dq = -q dg/g + (B dkappa)'/g
    const label n = curve.size();
    const nodalMatrix& d = curve.basis().derivative();
    const nodalMatrix d2 = d*d;
    const nodalVectors x1 = d*curve.nodes();
    const nodalVectors x2 = d*x1;
    const nodalVectors& t = curve.tangent();
    const nodalScalars perLength = curve.metric().cwiseInverse();
    const nodalScalars perCube = perLength.array().cube();
    const nodalScalars q =
        curve.ds(nodalScalars(modulus_*(curve.curvature() - reference_)));

    for (label j = 0; j < 2; ++j)
    {
        const label other = 1 - j;
        const scalar sign = (j == 0 ? 1 : -1);
        const nodalMatrix dg = t.col(j).asDiagonal()*d;

        nodalMatrix dkappa =
            nodalScalars(sign*perCube.cwiseProduct(x2.col(other))).asDiagonal()
           *d;
        dkappa -=
            nodalScalars(sign*perCube.cwiseProduct(x1.col(other))).asDiagonal()
           *d2;
        dkappa -=
            nodalScalars
            (
                3*curve.curvature().cwiseProduct(perLength)
            ).asDiagonal()*dg;

        nodalMatrix dq = modulus_*(perLength.asDiagonal()*(d*dkappa));
        dq -= nodalScalars(q.cwiseProduct(perLength)).asDiagonal()*dg;

        for (label i = 0; i < 2; ++i)
        {
            const nodalScalars turning =
                q.cwiseProduct(perLength).cwiseProduct(t.col(i))
               .cwiseProduct(curve.normal().col(j));
            nodalMatrix resultant = curve.normal().col(i).asDiagonal()*dq;
            resultant -= turning.asDiagonal()*d;
            jacobian.block(i*n, j*n, n, n) +=
                perLength.asDiagonal()*(d*resultant);
        }
    }
}
