/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceSamples.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::capsule::surfaceSamples::contains(const solvedVector& x) const
{
    if (x.size() == 2)
    {
        return inPolygon(x, points_);
    }
    Eigen::Index i;
    (points_.rowwise() - x).rowwise().squaredNorm().minCoeff(&i);
    return (x - points_.row(i)).dot(normals_.row(i)) < 0;
}
