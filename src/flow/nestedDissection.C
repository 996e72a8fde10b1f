/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "nestedDissection.H"
#include "ListOps.H"
#include "SubList.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::label Foam::capsule::nestedDissection::smallest_ = 8;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::nestedDissection::append(const label celli)
{
    order_.append(3*celli);
    order_.append(3*celli + 1);
    if (!separates_[celli])
    {
        order_.append(3*celli + 2);
    }
}


Foam::label Foam::capsule::nestedDissection::halve(UList<label>& cells) const
{
    solvedVector low = centres_.row(cells[0]);
    solvedVector high = low;
    for (const label celli : cells)
    {
        low = low.cwiseMin(centres_.row(celli));
        high = high.cwiseMax(centres_.row(celli));
    }
    Eigen::Index side;
    const scalar length = (high - low).maxCoeff(&side);

    // Between rows of cells: those of one row differ by round-off. If the lowest
    // row holds the middle, it is the half
    const auto middle = cells.begin() + cells.size()/2;
    std::nth_element
    (
        cells.begin(),
        middle,
        cells.end(),
        [&](const label a, const label b)
        {
            return centres_(a, side) < centres_(b, side);
        }
    );
    const scalar row = centres_(*middle, side);
    const scalar between =
        row + (row - low(side) < 1e-6*length ? 1e-6 : -1e-6)*length;
    return
        std::partition
        (
            cells.begin(),
            cells.end(),
            [&](const label celli)
            {
                return centres_(celli, side) < between;
            }
        )
      - cells.begin();
}


Foam::label Foam::capsule::nestedDissection::separate
(
    UList<label>& upper,
    const label below
)
{
    // Cells at the lower half last
    const label nBehind =
        std::partition
        (
            upper.begin(),
            upper.end(),
            [&](const label celli)
            {
                const labelList& beside = neighbours_[celli];
                return std::none_of
                (
                    beside.begin(),
                    beside.end(),
                    [&](const label other) { return half_[other] == below; }
                );
            }
        )
      - upper.begin();
    for (label i = nBehind; i < upper.size(); ++i)
    {
        half_[upper[i]] = 0;
    }
    return nBehind;
}


Foam::DynamicList<Foam::label>
Foam::capsule::nestedDissection::pressuresBehind
(
    const UList<label>& separator,
    const label above
)
{
    DynamicList<label> result;
    for (const label celli : separator)
    {
        for (const label other : neighbours_[celli])
        {
            if (half_[other] == above && !separates_[other])
            {
                separates_[other] = true;
                result.append(3*other + 2);
            }
        }
    }
    return result;
}


void Foam::capsule::nestedDissection::dissect(UList<label>& cells)
{
    if (cells.size() <= smallest_)
    {
        for (const label celli : cells)
        {
            append(celli);
        }
        return;
    }

    const label n = halve(cells);
    SubList<label> lower(cells, n);
    SubList<label> upper(cells, cells.size() - n, n);
    const label below = ++nHalves_;
    const label above = ++nHalves_;
    for (const label celli : lower)
    {
        half_[celli] = below;
    }
    for (const label celli : upper)
    {
        half_[celli] = above;
    }

    const label nBehind = separate(upper, below);
    SubList<label> behind(upper, nBehind);
    SubList<label> separator(upper, upper.size() - nBehind, nBehind);
    const DynamicList<label> pressures(pressuresBehind(separator, above));

    dissect(lower);
    dissect(behind);
    for (const label celli : separator)
    {
        append(celli);
    }
    order_.append(pressures);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::nestedDissection::nestedDissection
(
    const nodalVectors& centres,
    const labelListList& neighbours
)
:
    centres_(centres),
    neighbours_(neighbours),
    half_(neighbours.size(), 0),
    nHalves_(0),
    separates_(neighbours.size(), false),
    order_(3*neighbours.size())
{
    labelList cells(identity(neighbours.size()));
    dissect(cells);
}


// ************************************************************************* //
