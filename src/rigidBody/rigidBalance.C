/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rigidBalance.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::rigidBalance::rigidBalance
(
    const nodalMatrix& modes,
    const nodalMatrix& resultants,
    const slipResponse& slip,
    const nodalMatrix& mass,
    const nodalScalars& known
)
:
    modes_(modes),
    resultants_(resultants),
    resistance_(resultants*slip.force()),
    inside_(nodalMatrix::Zero(modes.cols(), modes.cols())),
    known_(known)
{
    const nodalMatrix whole = resistance_*modes_;
    if (slip.inertia().size())
    {
        inside_ = resultants_*slip.inertia()*modes_;
    }
    outside_ = whole - inside_;
    carriedBy_ = whole.inverse();
    response_ = (outside_ + mass).inverse();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::rigidBalance::velocity
(
    const nodalScalars& U,
    const nodalScalars& f,
    const nodalScalars& q,
    const bool change
) const
{
    nodalScalars wanted = outside_*carried(U) - resultants_*f + q;
    if (!change)
    {
        wanted += known_;
    }
    return response_*wanted;
}


// ************************************************************************* //
