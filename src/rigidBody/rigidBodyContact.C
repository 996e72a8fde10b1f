/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rigidBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::rigidBody::carried
(
    const nodalMatrix& U
) const
{
    return (resistance_*modes_).partialPivLu().solve(resistance_*U);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::rigidBody::pointsOf
(
    const nodalScalars& y
) const
{
    const nodalScalars V =
        motion_.free() ? nodalScalars(carried(y.head(nForce()))) : given_;

    return shape_->nodes(moved(V));
}


Foam::capsule::nodalMatrix Foam::capsule::rigidBody::pointsChange
(
    const nodalMatrix& dy
) const
{
    const label n = nForce();
    if (!motion_.free())
    {
        return nodalMatrix::Zero(n, dy.cols());
    }
    return modes_*carried(dy.topRows(n))/motionScheme().c;
}


Foam::capsule::nodalMatrix Foam::capsule::rigidBody::loaded
(
    const nodalMatrix& forces
) const
{
    if (!motion_.free())
    {
        return nodalMatrix::Zero(nForce(), forces.cols());
    }
    return
        inverse_
       *(modes_*(response_*(resultants_*(outerScale()*forces))));
}


// ************************************************************************* //
