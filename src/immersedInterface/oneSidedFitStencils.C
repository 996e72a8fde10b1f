/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "oneSidedFit.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::oneSidedFit::bandCells() const
{
    // Beyond an axis are the mirror images of the cells, numbered after them
    const membraneLevelSet& levelSet = interface_.levelSet();
    const labelUList& cells = levelSet.cells();
    const cellSearch& search = cellSearch::New(levelSet.mesh());
    const label d = levelSet.directions().size();
    nodalMatrix local(cells.size(), d + 1 + 2*d*d);
    forAll(cells, i)
    {
        const cellSearch::size& size = search.ofCell(cells[i]);
        const solvedTensor tensor = size.tensor();
        local.row(i).head(d) = levelSet.image(levelSet.mesh().C()[cells[i]]);
        local(i, d) = -side_*levelSet.distance()(i);
        for (label k = 0; k < d; ++k)
        {
            local.row(i).segment(d + 1 + k*d, d) = tensor.row(k);
            local.row(i).segment(d + 1 + d*d + k*d, d) = size.directions.row(k);
        }
    }
    nodalMatrix all = gather(local);
    if (levelSet.directions().axisymmetric())
    {
        const label n = all.rows();
        all.conservativeResize(2*n, all.cols());
        all.bottomRows(n) = all.topRows(n);
        for (label i = n; i < 2*n; ++i)
        {
            all.row(i).head(d) =
                levelSet.directions().mirrored(all.row(i).head(d));
        }
        for (const label odd : {4, 5, 8, 9})
        {
            all.col(odd).tail(n) *= -1;
        }
    }
    return all;
}


Foam::labelList Foam::capsule::oneSidedFit::seenFrom
(
    const solvedVector& x,
    const nodalMatrix& all,
    solvedTensor& toCells
) const
{
    const membraneLevelSet& levelSet = interface_.levelSet();
    const scalar width = levelSet.width();
    const label d = x.size();
    const List<lineOfSight::obstacle> obstacles
    (
        lineOfSight::near(levelSet.obstacles(), x, radius*width)
    );

    // Cells seen, and their mean size around the node
    nodalScalars squares(nodalScalars::Zero(all.rows()));
    for (label k = 0; k < d; ++k)
    {
        squares.array() += (all.col(k).array() - x(k)).square();
    }
    DynamicList<label> seen;
    solvedTensor mean(solvedTensor::Zero(d, d));
    scalar total = 0;
    label nearest = -1;

    for (label i = 0; i < all.rows(); ++i)
    {
        if
        (
            squares(i) < sqr(radius*width)
         && lineOfSight::clear(obstacles, x, all.row(i).head(d))
        )
        {
            seen.append(i);
            const scalar w =
                sqr(max(1 - squares(i)/sqr(1.5*width), scalar(0)));
            if (w > 0)
            {
                for (label k = 0; k < d; ++k)
                {
                    mean.row(k) += w*all.row(i).segment(d + 1 + k*d, d);
                }
                total += w;
            }
            if (nearest == -1 || squares(i) < squares(nearest))
            {
                nearest = i;
            }
        }
    }
    if (total == 0)
    {
        return labelList();
    }

    for (label k = 0; k < d; ++k)
    {
        toCells.row(k) = all.row(nearest).segment(d + 1 + d*d + k*d, d);
    }
    toCells *= (total*mean.inverse()).eval();
    return labelList(std::move(seen));
}


void Foam::capsule::oneSidedFit::setNode
(
    const label node,
    const nodalMatrix& all
)
{
    const membraneLevelSet& levelSet = interface_.levelSet();
    const closedSurface& surface = levelSet.surface();
    const label d = surface.nComponents();
    const solvedVector x = surface.nodes().row(node);

    // To cell widths along the directions of the mesh
    solvedTensor toCells(solvedTensor::Identity(d, d));
    const labelList seen(seenFrom(x, all, toCells));
    const scalar beyondCell =
        1/(toCells*surface.normal().row(node).transpose()).norm();

    DynamicList<label> near(seen.size());
    DynamicList<scalar> weights(seen.size());
    nodalVectors points(nodalVectors::Zero(seen.size(), d));
    for (const label i : seen)
    {
        auto r = points.row(near.size());
        r.setZero();
        for (label k = 0; k < d; ++k)
        {
            r += (all(i, k) - x(k))*toCells.col(k).transpose();
        }
        const scalar square = r.squaredNorm();
        const scalar beyond = max(all(i, d)/beyondCell, scalar(0));
        if (square < sqr(radius) && beyond < reach)
        {
            near.append(i);
            weights.append
            (
                sqr((1 - square/sqr(radius))*(1 - sqr(beyond/reach)))
            );
        }
    }

    rows_[node] = cubicFit
    (
        points.topRows(near.size()),
        Eigen::Map<const nodalScalars>(weights.cdata(), weights.size())
    );
    if (seen.empty() || rows_[node].cols() == 0)
    {
        FatalErrorInFunction
            << "Only " << near.size() << " cells around the membrane "
            << levelSet.name() << " at " << levelSet.directions().toPoint(x)
            << ": it has left the mesh or touches a wall"
            << exit(FatalError);
    }
    stencils_[node] = near;
    rows_[node].bottomRows(d) =
        (toCells.transpose()*rows_[node].bottomRows(d)).eval();
}


// ************************************************************************* //
