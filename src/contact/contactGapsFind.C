/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "contactGaps.H"

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

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::contactGaps::append
(
    const PtrList<closedSurface>& surfaces,
    const label part,
    const label other,
    const UList<label>& nodes,
    const nodalVectors& feet,
    const UList<surfaceParameter>& parameters
)
{
    if (nodes.empty())
    {
        return;
    }
    const closedSurface& surface = surfaces[part];
    const surfaceBasis& basis = surface.basis();
    const nodalScalars areas = basis.weights().cwiseProduct(surface.areaElement());
    const scalar rings = scalar(basis.size())/basis.nCounted();
    const label m = nodes.size();

    block b;
    b.part = part;
    b.other = other;
    b.gap.resize(m);
    b.area.resize(m);
    b.start = size_;
    b.byPoints.resize(m, basis.nComponents()*basis.nPacked());
    nodalMatrix atFeet;
    if (other >= 0)
    {
        const surfaceBasis& otherBasis = surfaces[other].basis();
        atFeet = otherBasis.functions(parameters)*otherBasis.analysis();
        b.byOther.resize(m, otherBasis.nComponents()*otherBasis.nPacked());
    }
    for (label i = 0; i < m; ++i)
    {
        const solvedVector d = surface.nodes().row(nodes[i]) - feet.row(i);
        b.gap(i) = d.norm();
        b.area(i) = (other >= 0 ? 0.5 : 1)*rings*areas(nodes[i]);

        const solvedVector normal = d/max(b.gap(i), VSMALL);
        nodalVectors own = nodalVectors::Zero(basis.size(), d.size());
        own.row(nodes[i]) = normal;
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

    DynamicList<label> nodes;
    DynamicList<surfaceParameter> found;
    nodalVectors feet(surface.size(), surface.nComponents());
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
            feet.row(nodes.size()) = foot;
            nodes.append(i);
            found.append(at);
        }
    }
    append(surfaces, part, other, nodes, feet, found);
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
    const label n = surface.basis().nCounted();
    nodalVectors feet(n, surface.nComponents());
    const labelList nodes
    (
        boundary.nearestOnWalls(surface.nodes().topRows(n), reach, feet)
    );
    append(surfaces, part, -1, nodes, feet, List<surfaceParameter>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::contactGaps::contactGaps
(
    const PtrList<closedSurface>& surfaces,
    const solvedDirections& directions,
    const meshBoundary& boundary,
    const scalar reach
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
        findWalls(surfaces, i, boundary, reach);
    }
}


// ************************************************************************* //
