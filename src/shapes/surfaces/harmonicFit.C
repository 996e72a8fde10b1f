/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "harmonicFit.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Degrees of the fits that follow each other
static const label firstDegree = 6;
static const label lastDegree = 20;
static const label degreeStep = 2;

//- Fits of each degree, and more of the last one
static const label nFits = 4;
static const label nLastFits = 8;

//- Factor of the penalty
static const scalar penalty = 1e-4;

//- Steps to a foot, none of them longer than this: a first surface is far off,
//  and its feet on the wrong side of a wall would turn points over for good
static const label nSteps = 3;
static const scalar longestStep = 0.01;

//- Points whose functions are held at a time
static const label nBlock = 512;

static nodalVectors rowsOf(const pointField& points)
{
    nodalVectors x(points.size(), 3);
    forAll(points, i)
    {
        x.row(i) << points[i].x(), points[i].y(), points[i].z();
    }
    return x;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::harmonicFit::fit(const label degree)
{
    harmonics_.reset(new sphericalHarmonics(degree));
    const label n = harmonics_->size();
    nodalMatrix a = nodalMatrix::Zero(n, n);
    nodalMatrix b = nodalMatrix::Zero(n, 3);
    nodalMatrix block(n, nBlock);
    for (label start = 0; start < y_.size(); start += nBlock)
    {
        const label size = min(nBlock, y_.size() - start);
        block.resize(n, size);
        nodalMatrix values(size, 3);
        for (label i = 0; i < size; ++i)
        {
            const scalar root = std::sqrt(weights_[start + i]);
            block.col(i) = root*harmonics_->values(y_[start + i]);
            values.row(i) = root*x_.row(start + i);
        }
        a.selfadjointView<Eigen::Lower>().rankUpdate(block);
        b.noalias() += block*values;
    }
    for (label k = 0; k < n; ++k)
    {
        const label l = sphericalHarmonics::degreeOf(k);
        a(k, k) +=
            penalty*sqr(scalar(l*(l + 1))/scalar(degree*(degree + 1)));
    }
    coefficients_ = a.selfadjointView<Eigen::Lower>().ldlt().solve(b);
}


void Foam::capsule::harmonicFit::findFeet()
{
    forAll(y_, i)
    {
        y_[i] = foot(point(x_(i, 0), x_(i, 1), x_(i, 2)), y_[i]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::harmonicFit::harmonicFit
(
    const pointField& points,
    const vectorField& unitVectors,
    const scalarField& weights,
    const scalar tolerance
)
:
    x_(rowsOf(points)),
    weights_(weights),
    y_(unitVectors)
{
    for
    (
        label degree = firstDegree;
        degree == firstDegree
     || (degree <= lastDegree && distance() > tolerance);
        degree += degreeStep
    )
    {
        for (label i = 0; i < (degree == lastDegree ? nLastFits : nFits); ++i)
        {
            fit(degree);
            findFeet();
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::capsule::harmonicFit::position(const vector& y) const
{
    const solvedVector x =
        harmonics_->values(y).transpose()*coefficients_;
    return point(x(0), x(1), x(2));
}


Foam::vector Foam::capsule::harmonicFit::normal(const vector& y) const
{
    vector e1;
    vector e2;
    sphericalHarmonics::tangents(y, e1, e2);
    sphericalHarmonics::fieldExpansion x;
    harmonics_->expand(y, e1, e2, coefficients_, x);
    const vector a(x(1, 0), x(1, 1), x(1, 2));
    const vector b(x(2, 0), x(2, 1), x(2, 2));
    return a ^ b;
}


Foam::vector Foam::capsule::harmonicFit::foot
(
    const point& x,
    const vector& guess
) const
{
    // Gauss-Newton: the part of the distance along the surface vanishes
    vector y(guess);
    for (label step = 0; step < nSteps; ++step)
    {
        vector e1;
        vector e2;
        sphericalHarmonics::tangents(y, e1, e2);
        sphericalHarmonics::fieldExpansion s;
        harmonics_->expand(y, e1, e2, coefficients_, s);
        const vector d = x - vector(s(0, 0), s(0, 1), s(0, 2));
        const vector a(s(1, 0), s(1, 1), s(1, 2));
        const vector b(s(2, 0), s(2, 1), s(2, 2));
        const scalar aa = a & a;
        const scalar ab = a & b;
        const scalar bb = b & b;
        const scalar det = aa*bb - sqr(ab);
        if (!(det > 1e-12*aa*bb))
        {
            break;
        }
        vector shift =
            (((d & a)*bb - (d & b)*ab)*e1 + ((d & b)*aa - (d & a)*ab)*e2)/det;
        shift *= min(scalar(1), longestStep/max(mag(shift), VSMALL));
        y = normalised(y + shift);
    }
    return y;
}


Foam::scalar Foam::capsule::harmonicFit::distance() const
{
    scalar result = 0;
    forAll(y_, i)
    {
        const point x(x_(i, 0), x_(i, 1), x_(i, 2));
        result = max(result, mag(position(y_[i]) - x));
    }
    return result;
}
