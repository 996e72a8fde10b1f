/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "nesting.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::nesting::nesting
(
    const clearance& distances,
    const List<surfaceSamples>& samples
)
:
    outer_(samples.size(), -1)
{
    // Of those around one, the next has most around itself
    List<labelList> around(samples.size());
    forAll(samples, i)
    {
        forAll(samples, j)
        {
            if (i != j && distances.inside(samples[i], samples[j]))
            {
                around[i].append(j);
            }
        }
    }
    forAll(around, i)
    {
        for (const label j : around[i])
        {
            if
            (
                outer_[i] < 0
             || around[j].size() > around[outer_[i]].size()
            )
            {
                outer_[i] = j;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::capsule::nesting::depth(const label i) const
{
    return outer_[i] < 0 ? 0 : 1 + depth(outer_[i]);
}


bool Foam::capsule::nesting::inside(const label i, const label j) const
{
    return outer_[i] >= 0 && (outer_[i] == j || inside(outer_[i], j));
}


Foam::labelList Foam::capsule::nesting::sort(const label n)
{
    labelList order(identity(outer_.size()));
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label i, const label j)
        {
            return (i < n) != (j < n) ? i < n : depth(i) < depth(j);
        }
    );

    labelList newPlace(order.size());
    forAll(order, k)
    {
        newPlace[order[k]] = k;
    }
    labelList outer(order.size());
    forAll(order, k)
    {
        const label around = outer_[order[k]];
        outer[k] = around < 0 ? -1 : newPlace[around];
    }
    outer_.transfer(outer);
    return newPlace;
}


// ************************************************************************* //
