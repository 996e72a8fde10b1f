/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceBasis.H"
#include "axisymmetricBasis.H"
#include "sphericalBasis.H"
#include "solvedDirections.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::capsule::surfaceBasis> Foam::capsule::surfaceBasis::New
(
    const solvedDirections& directions,
    const label n
)
{
    return autoPtr<surfaceBasis>
    (
        directions.axisymmetric()
      ? new axisymmetricBasis(n, directions.axisAt())
      : new curveBasis(n)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::capsule::curveBasis& Foam::capsule::surfaceBasis::curve() const
{
    FatalErrorInFunction
        << "A surface in space is no curve" << abort(FatalError);
    return static_cast<const curveBasis&>(*this);
}


const Foam::capsule::sphericalBasis&
Foam::capsule::surfaceBasis::spherical() const
{
    FatalErrorInFunction
        << "A curve is no surface in space" << abort(FatalError);
    return static_cast<const sphericalBasis&>(*this);
}


// ************************************************************************* //
