/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphericalMap.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include <algorithm>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Degree of the harmonics of the density
static const label densityDegree = 12;

//- How often the points flow to an even density: one of harmonics resolves a
//  strongly uneven one only in part
static const label nFlows = 6;

//- Of the time of a flow, the first and last moments, in which harmonics of the
//  highest and of the first degree decay, and the ratio of following ones
static const scalar firstTime = 0.01;
static const scalar lastTime = 2;
static const scalar timeRatio = 1.35;

//- Sweeps of the smoothing, and triangles for each one more: they reach a
//  distance that does not depend on the size of the triangles, far enough from
//  where the plane ended
static const label leastSweeps = 20;
static const label trianglesPerSweep = 300;

//- Tangent of half the angle at a between b and c
static scalar tanHalf(const point& a, const point& b, const point& c)
{
    const vector u = b - a;
    const vector v = c - a;
    const scalar below = mag(u)*mag(v) + (u & v);
    return mag(u ^ v)/max(below, 1e-9*mag(u)*mag(v));
}


//- Velocity of a point of the sphere, down a density
static vector velocity
(
    const vector& y,
    const sphericalHarmonics& harmonics,
    const nodalScalars& density
)
{
    vector e1;
    vector e2;
    sphericalHarmonics::tangents(y, e1, e2);
    sphericalHarmonics::fieldExpansion rho;
    harmonics.expand(y, e1, e2, density, rho);

    // A sum of harmonics may fall below zero
    return -(rho(1, 0)*e1 + rho(2, 0)*e2)/max(rho(0, 0), scalar(0.05));
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::sphericalMap::project()
{
    const point centre = surface_.centroid();
    forAll(y_, i)
    {
        y_[i] = normalised(surface_.points()[i] - centre);
    }
    for (const triFace& t : surface_.triangles())
    {
        if (((y_[t[0]] ^ y_[t[1]]) & y_[t[2]]) <= 0)
        {
            return false;
        }
    }
    return true;
}


void Foam::capsule::sphericalMap::setWeights()
{
    const pointField& x = surface_.points();
    std::vector<Eigen::Triplet<scalar>> entries;
    for (const triFace& t : surface_.triangles())
    {
        for (label k = 0; k < 3; ++k)
        {
            const label i = t[k];
            const label j = t[(k + 1) % 3];
            const label m = t[(k + 2) % 3];
            const scalar w = tanHalf(x[i], x[j], x[m]);
            entries.emplace_back(i, j, w/mag(x[j] - x[i]));
            entries.emplace_back(i, m, w/mag(x[m] - x[i]));
        }
    }
    weights_.resize(x.size(), x.size());
    weights_.setFromTriplets(entries.begin(), entries.end());
    const nodalScalars sums = weights_*nodalScalars::Ones(x.size());
    weights_ = sums.cwiseInverse().asDiagonal()*weights_;
}


Foam::capsule::nodalVectors Foam::capsule::sphericalMap::embedded() const
{
    // The first triangle is the outer side of the others: turned round
    const triFace& outer = surface_.triangles()[0];
    nodalMatrix b = nodalMatrix::Zero(y_.size(), 2);
    nodalScalars inner = nodalScalars::Ones(y_.size());
    for (label k = 0; k < 3; ++k)
    {
        const scalar angle = -k*constant::mathematical::twoPi/3;
        inner(outer[k]) = 0;
        b.row(outer[k]) << std::cos(angle), std::sin(angle);
    }
    Eigen::SparseMatrix<scalar> a(y_.size(), y_.size());
    a.setIdentity();
    a -= Eigen::SparseMatrix<scalar>(inner.asDiagonal()*weights_);
    Eigen::SparseLU<Eigen::SparseMatrix<scalar>> solver(a);
    return solver.solve(b);
}


Foam::scalar Foam::capsule::sphericalMap::median
(
    const nodalScalars& values
) const
{
    scalarList unsorted(values.size());
    std::copy_n(values.data(), values.size(), unsorted.begin());
    const labelList order(sortedOrder(unsorted));
    scalar below = 0;
    for (const label i : order)
    {
        below += parts_[i];
        if (below >= 0.5)
        {
            return values(i);
        }
    }
    return values(order.last());
}


void Foam::capsule::sphericalMap::wrap(nodalVectors u)
{
    u.col(0).array() -= median(u.col(0));
    u.col(1).array() -= median(u.col(1));
    u /= median(u.rowwise().norm());
    forAll(y_, i)
    {
        const scalar square = u.row(i).squaredNorm();
        y_[i] = vector(2*u(i, 0), 2*u(i, 1), 1 - square)/(1 + square);
    }
}


void Foam::capsule::sphericalMap::smooth()
{
    const label n =
        leastSweeps + surface_.triangles().size()/trianglesPerSweep;
    for (label sweep = 0; sweep < n; ++sweep)
    {
        for (label i = 0; i < y_.size(); ++i)
        {
            vector mean(Zero);
            for (weightMatrix::InnerIterator it(weights_, i); it; ++it)
            {
                mean += it.value()*y_[it.col()];
            }
            y_[i] = normalised(mean);
        }
    }
}


void Foam::capsule::sphericalMap::spread()
{
    const sphericalHarmonics harmonics(densityDegree);
    for (label flow = 0; flow < nFlows; ++flow)
    {
        nodalScalars density = nodalScalars::Zero(harmonics.size());
        forAll(y_, i)
        {
            density += parts_[i]*harmonics.values(y_[i]);
        }
        const auto at = [&](const scalar time)
        {
            nodalScalars result(density);
            for (label k = 0; k < result.size(); ++k)
            {
                const label l = sphericalHarmonics::degreeOf(k);
                result(k) *= std::exp(-l*(l + 1)*time);
            }
            return result;
        };

        for (scalar time = firstTime; time < lastTime; time *= timeRatio)
        {
            const scalar step = (timeRatio - 1)*time;
            const nodalScalars now = at(time);
            const nodalScalars middle = at(time + 0.5*step);
            for (vector& y : y_)
            {
                const vector half =
                    normalised(y + 0.5*step*velocity(y, harmonics, now));
                y = normalised(y + step*velocity(half, harmonics, middle));
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sphericalMap::sphericalMap(const closedTriangulation& surface)
:
    surface_(surface),
    parts_(surface.areas()/sum(surface.areas())),
    y_(surface.points().size())
{
    if (!project())
    {
        setWeights();
        wrap(embedded());
        smooth();
    }
    spread();
}
