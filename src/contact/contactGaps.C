/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "contactGaps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::contactGaps::areas() const
{
    nodalScalars result(size_);
    for (const block& b : blocks_)
    {
        result.segment(b.start, b.area.size()) = b.area;
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::contactGaps::gaps() const
{
    nodalScalars result(size_);
    for (const block& b : blocks_)
    {
        result.segment(b.start, b.gap.size()) = b.gap;
    }
    return result;
}


void Foam::capsule::contactGaps::addChange
(
    const label part,
    const nodalMatrix& displacement,
    nodalMatrix& gaps
) const
{
    for (const block& b : blocks_)
    {
        if (b.part == part)
        {
            gaps.middleRows(b.start, b.gap.size()) += b.byPoints*displacement;
        }
        else if (b.other == part)
        {
            gaps.middleRows(b.start, b.gap.size()) += b.byOther*displacement;
        }
    }
}


Foam::capsule::nodalMatrix Foam::capsule::contactGaps::derivatives
(
    const label part,
    const label nUnknowns
) const
{
    nodalMatrix result(nodalMatrix::Zero(nUnknowns, size_));
    for (const block& b : blocks_)
    {
        if (b.part == part)
        {
            result.middleCols(b.start, b.gap.size()) = b.byPoints.transpose();
        }
        else if (b.other == part)
        {
            result.middleCols(b.start, b.gap.size()) = b.byOther.transpose();
        }
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::contactGaps::perArea
(
    const surfaceBasis& basis,
    const nodalScalars& areaElement,
    const nodalScalars& work
)
{
    if (basis.axisymmetric())
    {
        // Each node that counts has the ring of both halves of the meridian
        const label n = basis.nCounted();
        const nodalScalars ring =
            2*basis.weights().head(n).cwiseProduct(areaElement.head(n));
        return basis.unpack(work.cwiseQuotient(ring.replicate(2, 1)));
    }
    const scalar perUnknown = basis.nPacked()/basis.weights().sum();

    return scaled(perUnknown*areaElement.cwiseInverse(), basis.unpack(work));
}


// ************************************************************************* //
