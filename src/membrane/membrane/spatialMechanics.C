/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "spatialMechanics.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::spatialMechanics::spatialMechanics
(
    const dictionary& dict,
    const sphericalBasis& basis
)
:
    basis_(basis),
    weak_(dict, basis.harmonics().degree()),
    nodes_(basis.harmonics(), basis.grid().degree(), 1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::spatialMechanics::setReference
(
    const closedSurface& initial,
    const scalar stretch
)
{
    weak_.setReference(initial.coefficients(), stretch);
    referenceMetric_ = initial.areaElement()/sqr(stretch);
}


Foam::capsule::membraneMechanics::principalValues
Foam::capsule::spatialMechanics::principal(const closedSurface& surface) const
{
    const surfaceMechanics::principalValues p =
        weak_.principal(nodes_, surface.coefficients());

    return principalValues{p.l1, p.l2, p.T1, p.T2};
}


Foam::capsule::nodalMatrix Foam::capsule::spatialMechanics::forceJacobian
(
    const closedSurface& surface,
    const bool fullTangent
) const
{
    const label n = basis_.nPacked();
    const nodalMatrix perArea = basis_.multiplied
    (
        surface.areaElement().cwiseInverse(), nodalMatrix::Identity(n, n)
    );

    nodalMatrix result = weak_.jacobian(surface.coefficients(), fullTangent);
    for (label i = 0; i < 3; ++i)
    {
        result.middleRows(i*n, n) = perArea*result.middleRows(i*n, n);
    }
    return result;
}


// ************************************************************************* //
