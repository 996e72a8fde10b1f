/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "Helfrich.H"
#include "familyEntries.H"
#include "resultants.H"
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
    static const familyEntries<bendingModel> entries
    (
        {"bendingModulus", "referenceCurvature"}
    );
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
    const string others("initial, none, or a curvature [1/m]");
    const bool isWord = input::guarded
    (
        dict,
        entry,
        [&]() { return token(input::tokens(dict, entry)).isWord(); },
        others
    );
    if (isWord)
    {
        initial_ =
            input::choice
            (
                dict, entry, {"initial", "none"}, " or a curvature [1/m]"
            ) == "initial";
        return;
    }

    initial_ = false;
    uniform_ =
        input::getQuantity<scalar>(dict, entry, dimless/dimLength, others);
    if (!(mag(uniform_) <= input::largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << uniform_ << "; its magnitude may"
            << " be up to " << input::largest << " [1/m]" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalScalars
Foam::capsule::bendingModels::Helfrich::momentDifference
(
    const closedSurface& curve
) const
{
    return
        modulus_
       *(
            (curve.curvature() - reference_)
          - (curve.secondCurvature() - secondReference_)
        );
}


Foam::capsule::nodalScalars Foam::capsule::bendingModels::Helfrich::shear
(
    const closedSurface& curve
) const
{
    const nodalScalars moment = modulus_*(curve.curvature() - reference_);
    nodalScalars q = curve.ds(moment);
    if (curve.axisymmetric())
    {
        q += momentDifference(curve).cwiseProduct(curve.convergence());
    }
    return q;
}


Foam::capsule::nodalMatrix
Foam::capsule::bendingModels::Helfrich::curvatureChange
(
    const closedSurface& curve
) const
{
    // With x' = dx/dalpha, g = |x'|, kappa = x' x x''/g^3:
    //     dkappa = (dx' x x'' + x' x dx'')/g^3 - 3 kappa dg/g
    const label n = curve.size();
    const nodalMatrix& d = curve.basis().derivative();
    const nodalMatrix d2 = d*d;
    const nodalVectors x1 = d*curve.nodes();
    const nodalVectors x2 = d*x1;
    const nodalScalars perLength = curve.metric().cwiseInverse();
    const nodalScalars perCube = perLength.array().cube();

    nodalMatrix result(n, 2*n);
    for (label j = 0; j < 2; ++j)
    {
        const label other = 1 - j;
        const scalar sign = (j == 0 ? 1 : -1);
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
            ).asDiagonal()*(curve.tangent().col(j).asDiagonal()*d);
        result.middleCols(j*n, n) = dkappa;
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::bendingModels::Helfrich::shearChange
(
    const closedSurface& curve
) const
{
    // With dg = t.dx': d(dM1/ds) = -(dM1/ds) dg/g + (E_B dkappa)'/g
    const label n = curve.size();
    const nodalMatrix& d = curve.basis().derivative();
    const nodalScalars perLength = curve.metric().cwiseInverse();
    const nodalScalars slope =
        curve.ds(nodalScalars(modulus_*(curve.curvature() - reference_)));
    const nodalMatrix dkappa = curvatureChange(curve);

    nodalMatrix result(n, 2*n);
    for (label j = 0; j < 2; ++j)
    {
        nodalMatrix dq =
            modulus_*(perLength.asDiagonal()*(d*dkappa.middleCols(j*n, n)));
        dq -=
            nodalScalars(slope.cwiseProduct(perLength)).asDiagonal()
           *(curve.tangent().col(j).asDiagonal()*d);
        result.middleCols(j*n, n) = dq;
    }
    if (curve.axisymmetric())
    {
        addSecondChange(curve, dkappa, result);
    }
    return result;
}


void Foam::capsule::bendingModels::Helfrich::addSecondChange
(
    const closedSurface& curve,
    const nodalMatrix& dkappa,
    nodalMatrix& dq
) const
{
    // (E_B dkappa - E_B dK2) c'/c + (M1 - M2) d(c'/c), where K2 = n_r/c and
    // c'/c = t_r/c, with dn = -t (n.dx')/g, dt = n (n.dx')/g and dc = dr
    const label n = curve.size();
    const nodalMatrix& d = curve.basis().derivative();
    const nodalScalars& convergence = curve.convergence();
    const nodalScalars difference = momentDifference(curve);
    const nodalScalars perTurn =
    (
        modulus_*convergence.cwiseProduct(curve.tangent().col(1))
      + difference.cwiseProduct(curve.normal().col(1))
    ).cwiseQuotient(curve.areaElement());

    dq += nodalScalars(modulus_*convergence).asDiagonal()*dkappa;
    for (label j = 0; j < 2; ++j)
    {
        dq.middleCols(j*n, n) +=
            nodalScalars
            (
                perTurn.cwiseProduct(curve.normal().col(j))
            ).asDiagonal()*d;
    }
    dq.middleCols(n, n).diagonal() +=
        convergence.cwiseProduct
        (
            modulus_*curve.secondCurvature() - difference
        ).cwiseQuotient(curve.around());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::capsule::surfaceBending>
Foam::capsule::bendingModels::Helfrich::inSpace() const
{
    return autoPtr<surfaceBending>
    (
        new surfaceBending(modulus_, initial_, uniform_)
    );
}


void Foam::capsule::bendingModels::Helfrich::setReference
(
    const closedSurface& curve
)
{
    const nodalScalars uniform =
        nodalScalars::Constant(curve.size(), uniform_);

    reference_ = initial_ ? curve.curvature() : uniform;
    secondReference_ = initial_ ? curve.secondCurvature() : uniform;
}


void Foam::capsule::bendingModels::Helfrich::addResultant
(
    const closedSurface& curve,
    nodalVectors& resultant
) const
{
    resultant += scaled(shear(curve), curve.normal());
}


void Foam::capsule::bendingModels::Helfrich::addJacobian
(
    const closedSurface& curve,
    nodalMatrix& jacobian
) const
{
    // d(Q n) = dQ n - Q t (n.dx')/g
    const label n = curve.size();
    const nodalMatrix& d = curve.basis().derivative();
    const nodalVectors& normal = curve.normal();
    const nodalScalars q = shear(curve);
    const nodalScalars perLength = curve.metric().cwiseInverse();
    const nodalMatrix dq = shearChange(curve);

    for (label j = 0; j < 2; ++j)
    {
        for (label i = 0; i < 2; ++i)
        {
            const nodalScalars turning =
                q.cwiseProduct(perLength).cwiseProduct(curve.tangent().col(i))
               .cwiseProduct(normal.col(j));
            nodalMatrix change =
                normal.col(i).asDiagonal()*dq.middleCols(j*n, n);
            change -= turning.asDiagonal()*d;
            jacobian.block(i*n, j*n, n, n) += resultants::forceChange
            (
                curve, q.cwiseProduct(normal.col(i)), change, j
            );
        }
    }
}
