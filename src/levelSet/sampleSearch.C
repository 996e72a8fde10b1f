/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sampleSearch.H"
#include "ListOps.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::sampleSearch::sort
(
    const nodalVectors& samples,
    const label begin,
    const label end,
    const label largest
)
{
    if (end - begin <= largest)
    {
        starts_.append(begin);
        return;
    }

    solvedVector low = samples.row(numbers_[begin]);
    solvedVector high = low;
    for (label i = begin + 1; i < end; ++i)
    {
        low = low.cwiseMin(samples.row(numbers_[i]));
        high = high.cwiseMax(samples.row(numbers_[i]));
    }
    Eigen::Index longest;
    (high - low).maxCoeff(&longest);

    const label middle = (begin + end)/2;
    std::nth_element
    (
        numbers_.begin() + begin,
        numbers_.begin() + middle,
        numbers_.begin() + end,
        [&](const label a, const label b)
        {
            return samples(a, longest) < samples(b, longest);
        }
    );
    sort(samples, begin, middle, largest);
    sort(samples, middle, end, largest);
}


void Foam::capsule::sampleSearch::search
(
    const label block,
    const scalar* x,
    scalar& bound,
    label& found
) const
{
    const label d = x_.rows();
    const scalar* sample = x_.data() + d*starts_[block];
    for (label i = starts_[block]; i < starts_[block + 1]; ++i, sample += d)
    {
        scalar square = 0;
        for (label k = 0; k < d; ++k)
        {
            square += sqr(x[k] - sample[k]);
        }
        if (square < bound)
        {
            bound = square;
            found = i;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sampleSearch::sampleSearch(const nodalVectors& samples)
:
    numbers_(identity(samples.rows())),
    x_(samples.cols(), samples.rows())
{
    sort
    (
        samples, 0, samples.rows(), label(std::sqrt(samples.rows()/3.0)) + 1
    );
    const label n = starts_.size();
    starts_.append(samples.rows());

    forAll(numbers_, i)
    {
        x_.col(i) = samples.row(numbers_[i]).transpose();
    }
    centres_.resize(n, samples.cols());
    radii_.resize(n);
    for (label i = 0; i < n; ++i)
    {
        const auto block =
            x_.middleCols(starts_[i], starts_[i + 1] - starts_[i]);
        const nodalScalars centre =
            0.5*(block.rowwise().minCoeff() + block.rowwise().maxCoeff());
        centres_.row(i) = centre.transpose();
        radii_(i) = std::sqrt
        (
            (block.colwise() - centre).colwise().squaredNorm().maxCoeff()
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::capsule::sampleSearch::nearest
(
    const solvedVector& x,
    scalar& bound
) const
{
    // First the block whose centre is nearest: it bounds the others
    nodalScalars squares(nodalScalars::Zero(radii_.size()));
    for (label k = 0; k < x.size(); ++k)
    {
        squares.array() += (centres_.col(k).array() - x(k)).square();
    }
    Eigen::Index first;
    squares.minCoeff(&first);

    label found = -1;
    search(first, x.data(), bound, found);
    scalar distance = std::sqrt(bound);
    forAll(squares, i)
    {
        if (i != first && squares(i) < sqr(distance + radii_(i)))
        {
            search(i, x.data(), bound, found);
            distance = std::sqrt(bound);
        }
    }
    return found == -1 ? -1 : numbers_[found];
}


Foam::label Foam::capsule::sampleSearch::nearest(const solvedVector& x) const
{
    scalar bound = GREAT*GREAT;
    return nearest(x, bound);
}


// ************************************************************************* //
