/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "oneSidedFit.H"
#include "releases.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::oneSidedFit::radius = 3.1;
const Foam::scalar Foam::capsule::oneSidedFit::reach = 2;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::oneSidedFit::gather
(
    const nodalMatrix& local
) const
{
    if (!Pstream::parRun())
    {
        return local;
    }

    List<scalarList> parts(Pstream::nProcs());
    parts[Pstream::myProcNo()] = scalarList
    (
        UList<scalar>(const_cast<scalar*>(local.data()), local.size())
    );
    allGatherList(parts);

    nodalMatrix all(sum(sizes_), local.cols());
    label start = 0;
    forAll(parts, proci)
    {
        if (sizes_[proci])
        {
            all.middleRows(start, sizes_[proci]) =
                Eigen::Map<const nodalMatrix>
                (
                    parts[proci].cdata(), sizes_[proci], local.cols()
                );
        }
        start += sizes_[proci];
    }
    return all;
}


Foam::capsule::oneSidedFit::fitted Foam::capsule::oneSidedFit::fit
(
    const volVectorField& U,
    const volScalarField* p,
    const bool jumping
) const
{
    const membraneLevelSet& levelSet = interface_.levelSet();
    const labelUList& cells = levelSet.cells();
    const label d = levelSet.directions().size();
    const label fields = (p ? d + 1 : d);

    // Values as the side sees them
    nodalMatrix local(cells.size(), fields);
    forAll(cells, i)
    {
        const label celli = cells[i];
        const scalar cellSide = (levelSet.distance()(i) < 0 ? -1 : 1);
        const scalar beyond = (jumping && cellSide != side_ ? cellSide : 0);

        solvedVector u = levelSet.directions()(U[celli]);
        if (beyond != 0)
        {
            u -= beyond*interface_.jumpU().row(i);
        }
        local.row(i).head(d) = u;

        if (p)
        {
            local(i, d) =
                (*p)[celli]
              - (beyond != 0 ? beyond*interface_.jumpp()(i) : 0);
        }
    }
    const nodalMatrix values = gather(local);

    const label n = stencils_.size();
    nodalMatrix found[4];
    for (nodalMatrix& m : found)
    {
        m.resize(n, fields);
    }
    forAll(stencils_, node)
    {
        const labelList& stencil = stencils_[node];
        nodalMatrix f(stencil.size(), fields);
        forAll(stencil, i)
        {
            const label celli = stencil[i] % values.rows();
            f.row(i) = values.row(celli);
            if (celli != stencil[i])
            {
                // Beyond the axis
                f(i, 1) = -f(i, 1);
            }
        }
        const nodalMatrix fit = rows_[node]*f;
        for (label k = 0; k <= d; ++k)
        {
            found[k].row(node) = fit.row(k);
        }
    }
    return extended(found);
}


Foam::capsule::oneSidedFit::fitted Foam::capsule::oneSidedFit::extended
(
    const nodalMatrix (&found)[4]
) const
{
    const closedSurface& surface = interface_.levelSet().surface();
    const label fields = found[0].cols();
    const auto all = [&](const label k)
    {
        // Odd beyond an axis: the component away from it, and derivatives
        // in its direction
        nodalMatrix result(surface.size(), fields);
        for (label i = 0; i < fields; ++i)
        {
            result.col(i) =
                surface.basis().extended(found[k].col(i), (i == 1) == (k == 2));
        }
        return result;
    };

    fitted result;
    result.value = all(0);
    result.divergence = nodalScalars::Zero(surface.size());
    for (label i = 0; i < surface.nComponents(); ++i)
    {
        result.gradient[i] = all(1 + i);
        result.divergence += result.gradient[i].col(i);
    }
    if (surface.axisymmetric())
    {
        result.hoopRate = result.value.col(1).cwiseQuotient(surface.around());
        result.divergence += result.hoopRate;
    }
    return result;
}


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
    const nodalScalars squares =
        (all.leftCols(d).rowwise() - x).rowwise().squaredNorm();
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

    DynamicList<label> near;
    DynamicList<scalar> weights;
    nodalVectors points(seen.size(), d);
    for (const label i : seen)
    {
        const solvedVector r = (all.row(i).head(d) - x)*toCells.transpose();
        const scalar beyond = max(all(i, d)/beyondCell, scalar(0));
        if (r.norm() < radius && beyond < reach)
        {
            points.row(near.size()) = r;
            near.append(i);
            weights.append
            (
                sqr
                (
                    (1 - r.squaredNorm()/sqr(radius))
                   *(1 - sqr(beyond/reach))
                )
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::oneSidedFit::oneSidedFit
(
    const immersedInterface& interface,
    const label side
)
:
    interface_(interface),
    side_(side),
    sizes_(Pstream::nProcs(), Zero)
{
    sizes_[Pstream::myProcNo()] = interface.levelSet().cells().size();
    allGatherList(sizes_);

    const nodalMatrix all = bandCells();
    const label n = interface.levelSet().surface().basis().nCounted();
    stencils_.setSize(n);
    rows_.setSize(n);
    for (label node = 0; node < n; ++node)
    {
        setNode(node, all);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::oneSidedFit::fitted::viscous
(
    const nodalVectors& n,
    const scalar mu
) const
{
    nodalVectors result = nodalVectors::Zero(n.rows(), n.cols());
    for (label i = 0; i < n.cols(); ++i)
    {
        for (label j = 0; j < n.cols(); ++j)
        {
            result.col(i) +=
                mu*n.col(j).cwiseProduct
                (
                    gradient[j].col(i) + gradient[i].col(j)
                );
        }
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::oneSidedFit::fitted::pressure
(
    const scalar mu
) const
{
    // The interpolation of velocity to faces leaves an error of second order in
    // the fluxes, which jumps at the membrane: a layer of divergence s in the
    // cut cells, of first order, and in it a pressure of mu s too much. So the
    // divergence that the fit sees is taken off the pressure.
    return value.rightCols(1) + mu*divergence;
}


Foam::capsule::nodalVectors Foam::capsule::oneSidedFit::fitted::vorticity
(
    const nodalVectors& n
) const
{
    nodalVectors result = nodalVectors::Zero(n.rows(), n.cols());

    for (label i = 0; i < n.cols(); ++i)
    {
        for (label j = 0; j < n.cols(); ++j)
        {
            result.col(i) += n.col(j).cwiseProduct
            (
                gradient[j].col(i) - gradient[i].col(j)
            );
        }
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::oneSidedFit::fitted::traction
(
    const nodalVectors& n,
    const scalar mu
) const
{
    return viscous(n, mu) - scaled(pressure(mu), n);
}
