/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "contactGaps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::contactGaps::leastFacing_ = -0.5;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- The middle of the box around points
static solvedVector middle(const nodalVectors& x)
{
    return 0.5*(x.colwise().minCoeff() + x.colwise().maxCoeff());
}

//- Are the boxes around two sets of points apart by more than a reach, the
//  second one moved?
static bool apart
(
    const nodalVectors& a,
    const nodalVectors& b,
    const solvedVector& shift,
    const scalar reach
)
{
    const solvedVector below =
        b.colwise().minCoeff() + shift - a.colwise().maxCoeff();
    const solvedVector above =
        a.colwise().minCoeff() - b.colwise().maxCoeff() - shift;
    return max(below.maxCoeff(), above.maxCoeff()) > reach;
}

//- Weights at all nodes that do the same work as given ones by what the
//  symmetry of the basis permits
static nodalVectors symmetricWeights
(
    const surfaceBasis& basis,
    nodalVectors weights
)
{
    if (basis.axisymmetric())
    {
        nodalVectors mirrored = weights.colwise().reverse();
        mirrored.col(1) *= -1;
        weights = 0.5*(weights + mirrored);
    }
    return weights;
}

//- The number of the nearest of samples closer to a point x than a reach that
//  face its normal n, of those permitted; -1 without
template<class Permitted>
static label nearestFacing
(
    const nodalVectors& samples,
    const nodalVectors& normals,
    const solvedVector& x,
    const solvedVector& n,
    const scalar leastFacing,
    const scalar reach,
    const Permitted& permitted
)
{
    scalar least = sqr(reach);
    label nearest = -1;
    for (label j = 0; j < samples.rows(); ++j)
    {
        const scalar square = (samples.row(j) - x).squaredNorm();
        if
        (
            square < least && normals.row(j).dot(n) < leastFacing
         && permitted(samples.row(j))
        )
        {
            least = square;
            nearest = j;
        }
    }
    return nearest;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::contactGaps::append
(
    const PtrList<closedSurface>& surfaces,
    const label part,
    const label other,
    const feet& found
)
{
    const label m = found.nodes.size();
    if (m == 0)
    {
        return;
    }
    const closedSurface& surface = surfaces[part];
    const surfaceBasis& basis = surface.basis();
    const nodalScalars areas = basis.weights().cwiseProduct(surface.areaElement());
    const scalar rings = scalar(basis.size())/basis.nCounted();

    block b;
    b.part = part;
    b.other = (other == part ? -1 : other);
    b.gap.resize(m);
    b.area.resize(m);
    b.start = size_;
    b.byPoints.resize(m, basis.nComponents()*basis.nPacked());
    nodalMatrix atFeet;
    if (other >= 0)
    {
        const surfaceBasis& otherBasis = surfaces[other].basis();
        atFeet = otherBasis.functions(found.parameters)*otherBasis.analysis();
        b.byOther.resize(m, otherBasis.nComponents()*otherBasis.nPacked());
    }
    for (label i = 0; i < m; ++i)
    {
        const label node = found.nodes[i];
        const solvedVector d = surface.nodes().row(node) - found.x.row(i);
        b.gap(i) = d.norm();
        b.area(i) = found.shares[i]*rings*areas(node);

        const solvedVector normal = d/max(b.gap(i), VSMALL);
        nodalVectors own = nodalVectors::Zero(basis.size(), d.size());
        own.row(node) = normal;
        b.byPoints.row(i) =
            basis.packedWeights(symmetricWeights(basis, own)).transpose();
        if (other >= 0)
        {
            const surfaceBasis& otherBasis = surfaces[other].basis();
            const nodalVectors foot = -atFeet.row(i).transpose()*normal;
            b.byOther.row(i) =
                otherBasis.packedWeights(symmetricWeights(otherBasis, foot))
               .transpose();
        }
    }
    if (other == part)
    {
        b.byPoints += b.byOther;
        b.byOther.resize(0, 0);
    }
    size_ += m;
    blocks_.append(b);
}


void Foam::capsule::contactGaps::findOther
(
    const PtrList<closedSurface>& surfaces,
    const label part,
    const label other,
    const solvedVector& shift,
    const scalar reach
)
{
    const closedSurface& surface = surfaces[part];
    const closedSurface& facing = surfaces[other];
    if (apart(surface.nodes(), facing.nodes(), shift, reach))
    {
        return;
    }

    const List<surfaceParameter> parameters(facing.basis().samples());
    const nodalVectors samples = facing.sampled().rowwise() + shift;
    const scalar near = sqr(reach + facing.sampleSpacing());

    feet found(surface);
    for (label i = 0; i < surface.basis().nCounted(); ++i)
    {
        const solvedVector x = surface.nodes().row(i);
        Eigen::Index nearest;
        const scalar square =
            (samples.rowwise() - x).rowwise().squaredNorm().minCoeff(&nearest);
        if (square > near)
        {
            continue;
        }
        surfaceParameter at = parameters[nearest];
        const solvedVector foot = facing.foot(x - shift, at).x + shift;
        if ((x - foot).norm() < reach)
        {
            found.append(i, foot, at, 0.5);
        }
    }
    append(surfaces, part, other, found);
}


void Foam::capsule::contactGaps::findFolds
(
    const PtrList<closedSurface>& surfaces,
    const solvedDirections& directions,
    const label part,
    const scalar reach
)
{
    const closedSurface& surface = surfaces[part];
    const surfaceBasis& basis = surface.basis();
    const List<surfaceParameter> parameters(basis.samples());
    nodalVectors samples(parameters.size(), surface.nComponents());
    nodalVectors normals(parameters.size(), surface.nComponents());
    forAll(parameters, j)
    {
        const surfacePoint p = surface.expand(parameters[j]);
        samples.row(j) = p.x;
        normals.row(j) = closedSurface::normal(p).normalized();
    }
    // About an axis not across it
    const auto permitted = [&](const solvedVector& x)
    {
        return directions.radius(x) > 0;
    };

    const scalar near = reach + surface.sampleSpacing();
    feet found(surface);
    for (label i = 0; i < basis.nCounted(); ++i)
    {
        const solvedVector x = surface.nodes().row(i);
        const solvedVector n = surface.normal().row(i);
        const label nearest = nearestFacing
        (
            samples, normals, x, n, leastFacing_, near, permitted
        );
        if (nearest < 0)
        {
            continue;
        }
        surfaceParameter at = parameters[nearest];
        const surfacePoint foot = surface.foot(x, at);
        const solvedVector d = foot.x - x;
        const scalar facing = closedSurface::normal(foot).normalized().dot(n);
        if
        (
            d.norm() < reach && facing < leastFacing_ && permitted(foot.x)
         && sqr(d.dot(n)) > 0.5*d.squaredNorm()
        )
        {
            found.append(i, foot.x, at, min(-facing + leastFacing_, 0.5));
        }
    }
    append(surfaces, part, part, found);
}


void Foam::capsule::contactGaps::findWalls
(
    const PtrList<closedSurface>& surfaces,
    const label part,
    const meshBoundary& boundary,
    const scalar reach
)
{
    const closedSurface& surface = surfaces[part];
    feet found(surface);
    found.nodes = boundary.nearestOnWalls
    (
        surface.nodes().topRows(surface.basis().nCounted()), reach, found.x
    );
    found.shares = scalarList(found.nodes.size(), scalar(1));
    append(surfaces, part, -1, found);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::contactGaps::contactGaps
(
    const PtrList<closedSurface>& surfaces,
    const solvedDirections& directions,
    const meshBoundary& boundary,
    const scalar reach,
    const bool folds
)
:
    points_(surfaces.size()),
    size_(0)
{
    forAll(surfaces, i)
    {
        points_[i] = surfaces[i].nodes();
    }
    forAll(surfaces, i)
    {
        const solvedVector centre = middle(points_[i]);
        forAll(surfaces, j)
        {
            if (j == i)
            {
                continue;
            }
            const solvedVector there = middle(points_[j]);
            for
            (
                const solvedVector& image
              : directions.images().images(there, centre)
            )
            {
                findOther(surfaces, i, j, image - there, reach);
            }
        }
        if (folds)
        {
            findFolds(surfaces, directions, i, reach);
        }
        findWalls(surfaces, i, boundary, reach);
    }
}


// ************************************************************************* //
