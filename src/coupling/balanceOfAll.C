/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "balanceOfAll.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using Foam::label;
    using Foam::capsule::stressBalance;

    //- Rows that a part has of unknowns and balances, and of answers
    label unknowns(const stressBalance& part)
    {
        return part.nUnknowns();
    }

    label answers(const stressBalance& part)
    {
        return part.answer().size();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
Foam::capsule::nodalMatrix Foam::capsule::balanceOfAll::mapped
(
    const nodalMatrix& rows,
    label (*size)(const stressBalance&),
    const Function& map
) const
{
    nodalMatrix result(0, rows.cols());
    label start = 0;
    for (const stressBalance& part : parts_)
    {
        const label n = size(part);
        const nodalMatrix found = map(part, rows.middleRows(start, n));
        start += n;

        result.conservativeResize(result.rows() + found.rows(), rows.cols());
        result.bottomRows(found.rows()) = found;
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::balanceOfAll::balanceOfAll
(
    const UPtrList<stressBalance>& parts
)
:
    parts_(parts)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::capsule::balanceOfAll::nUnknowns() const
{
    label n = 0;
    for (const stressBalance& part : parts_)
    {
        n += part.nUnknowns();
    }
    return n;
}


Foam::capsule::nodalScalars Foam::capsule::balanceOfAll::answer() const
{
    nodalScalars y;
    for (const stressBalance& part : parts_)
    {
        const nodalScalars found = part.answer();
        y.conservativeResize(y.size() + found.size());
        y.tail(found.size()) = found;
    }
    return y;
}


Foam::capsule::nodalScalars Foam::capsule::balanceOfAll::balance
(
    const nodalScalars& y
) const
{
    return mapped
    (
        y,
        answers,
        [](const stressBalance& part, const nodalMatrix& yi)
        {
            return part.balance(yi);
        }
    );
}


void Foam::capsule::balanceOfAll::linearise
(
    const nodalScalars& y,
    const bool whole
)
{
    label start = 0;
    for (stressBalance& part : parts_)
    {
        const label n = answers(part);
        part.linearise(y.segment(start, n), whole);
        start += n;
    }
}


Foam::scalar Foam::capsule::balanceOfAll::largestPart
(
    const nodalScalars& dy
) const
{
    scalar result = 1;
    label start = 0;
    for (const stressBalance& part : parts_)
    {
        const label n = answers(part);
        result = min(result, part.largestPart(dy.segment(start, n)));
        start += n;
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::balanceOfAll::balanceChange
(
    const nodalMatrix& dy
) const
{
    return mapped
    (
        dy,
        answers,
        [](const stressBalance& part, const nodalMatrix& dyi)
        {
            return part.balanceChange(dyi);
        }
    );
}


Foam::capsule::nodalMatrix Foam::capsule::balanceOfAll::step
(
    const nodalMatrix& balance
) const
{
    return mapped
    (
        balance,
        unknowns,
        [](const stressBalance& part, const nodalMatrix& balancei)
        {
            return part.step(balancei);
        }
    );
}


Foam::capsule::nodalScalars Foam::capsule::balanceOfAll::answerChange
(
    const nodalScalars& dx
) const
{
    return mapped
    (
        dx,
        unknowns,
        [](const stressBalance& part, const nodalMatrix& dxi)
        {
            return part.answerChange(dxi);
        }
    );
}
