/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "oneSidedFit.H"
#include "cubicFit.H"
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
    const label components = (p ? 3 : 2);

    // Values as the side sees them
    nodalMatrix local(cells.size(), components);
    forAll(cells, i)
    {
        const label celli = cells[i];
        const scalar cellSide = (levelSet.distance()(i) < 0 ? -1 : 1);
        const scalar beyond = (jumping && cellSide != side_ ? cellSide : 0);

        vector2 u = levelSet.plane()(U[celli]);
        if (beyond != 0)
        {
            u -= beyond*interface_.jumpU().row(i);
        }
        local.block<1, 2>(i, 0) = u;

        if (p)
        {
            local(i, 2) =
                (*p)[celli]
              - (beyond != 0 ? beyond*interface_.jumpp()(i) : 0);
        }
    }
    const nodalMatrix values = gather(local);

    const label n = stencils_.size();
    nodalMatrix found[3];
    for (nodalMatrix& m : found)
    {
        m.resize(n, components);
    }
    forAll(stencils_, node)
    {
        const labelList& stencil = stencils_[node];
        nodalMatrix f(stencil.size(), components);
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
        for (label k = 0; k < 3; ++k)
        {
            found[k].row(node) = fit.row(k);
        }
    }
    return extended(found);
}


Foam::capsule::oneSidedFit::fitted Foam::capsule::oneSidedFit::extended
(
    const nodalMatrix (&found)[3]
) const
{
    const closedSurface& curve = interface_.levelSet().curve();
    const label components = found[0].cols();
    const auto all = [&](const label k)
    {
        // Odd beyond an axis: the component away from it, and derivatives
        // in its direction
        nodalMatrix result(curve.size(), components);
        for (label i = 0; i < components; ++i)
        {
            result.col(i) =
                curve.basis().extended(found[k].col(i), (i == 1) == (k == 2));
        }
        return result;
    };

    fitted result;
    result.value = all(0);
    result.gradient[0] = all(1);
    result.gradient[1] = all(2);
    result.divergence = result.gradient[0].col(0) + result.gradient[1].col(1);
    if (curve.axisymmetric())
    {
        result.hoopRate = result.value.col(1).cwiseQuotient(curve.around());
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
    nodalMatrix local(cells.size(), 9);
    forAll(cells, i)
    {
        const cellSearch::size& size = search.ofCell(cells[i]);
        const Eigen::Matrix<scalar, 2, 2> tensor = size.tensor();
        local.row(i) <<
            levelSet.image(levelSet.mesh().C()[cells[i]]),
            -side_*levelSet.distance()(i),
            tensor.row(0), tensor.row(1),
            size.direction;
    }
    nodalMatrix all = gather(local);
    if (levelSet.curve().axisymmetric())
    {
        const label n = all.rows();
        all.conservativeResize(2*n, all.cols());
        all.bottomRows(n) = all.topRows(n);
        for (label i = n; i < 2*n; ++i)
        {
            all.row(i).head<2>() =
                levelSet.plane().mirrored(all.row(i).head<2>());
        }
        for (const label odd : {4, 5, 8})
        {
            all.col(odd).tail(n) *= -1;
        }
    }
    return all;
}


Foam::labelList Foam::capsule::oneSidedFit::seenFrom
(
    const vector2& x,
    const nodalMatrix& all,
    Eigen::Matrix<scalar, 2, 2>& toCells
) const
{
    const membraneLevelSet& levelSet = interface_.levelSet();
    const scalar width = levelSet.width();

    DynamicList<lineOfSight::obstacle> obstacles;
    for (const lineOfSight::obstacle& o : levelSet.obstacles())
    {
        const scalar length = (o.second() - o.first()).norm();
        if ((o.first() - x).norm() < radius*width + length)
        {
            obstacles.append(o);
        }
    }

    // Cells seen, and their mean size around the node
    DynamicList<label> seen;
    Eigen::Matrix<scalar, 2, 2> mean;
    mean.setZero();
    scalar total = 0;
    scalar nearest = GREAT;
    vector2 direction(1, 0);
    for (label i = 0; i < all.rows(); ++i)
    {
        const vector2 c = all.row(i).head<2>();
        const scalar d = (c - x).norm();
        if (d < radius*width && lineOfSight::clear(obstacles, x, c))
        {
            seen.append(i);
            const scalar w = sqr(max(1 - sqr(d/(1.5*width)), scalar(0)));
            mean.row(0) += w*all.block<1, 2>(i, 3);
            mean.row(1) += w*all.block<1, 2>(i, 5);
            total += w;
            if (d < nearest)
            {
                nearest = d;
                direction = all.block<1, 2>(i, 7);
            }
        }
    }
    if (total == 0)
    {
        return labelList();
    }

    toCells << direction, turned(direction);
    toCells *= total*mean.inverse();
    return labelList(std::move(seen));
}


void Foam::capsule::oneSidedFit::setNode
(
    const label node,
    const nodalMatrix& all
)
{
    const membraneLevelSet& levelSet = interface_.levelSet();
    const closedSurface& curve = levelSet.curve();
    const vector2 x = curve.nodes().row(node);

    // To cell widths along the directions of the mesh
    Eigen::Matrix<scalar, 2, 2> toCells;
    toCells.setIdentity();
    const labelList seen(seenFrom(x, all, toCells));
    const scalar beyondCell =
        1/(toCells*curve.normal().row(node).transpose()).norm();

    DynamicList<label> near;
    DynamicList<scalar> weights;
    nodalVectors points(seen.size(), 2);
    for (const label i : seen)
    {
        const vector2 d = (all.row(i).head<2>() - x)*toCells.transpose();
        const scalar beyond = max(all(i, 2)/beyondCell, scalar(0));
        if (d.norm() < radius && beyond < reach)
        {
            points.row(near.size()) = d;
            near.append(i);
            weights.append
            (
                sqr
                (
                    (1 - d.squaredNorm()/sqr(radius))
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
            << levelSet.name() << " at " << levelSet.plane().toPoint(x)
            << ": it has left the mesh or touches a wall"
            << exit(FatalError);
    }
    stencils_[node] = near;
    rows_[node].bottomRows<2>() =
        (toCells.transpose()*rows_[node].bottomRows<2>()).eval();
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
    const label n = interface.levelSet().curve().basis().nPacked();
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
    nodalVectors result = nodalVectors::Zero(n.rows(), 2);
    for (label i = 0; i < 2; ++i)
    {
        for (label j = 0; j < 2; ++j)
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
    return value.col(2) + mu*divergence;
}


Foam::capsule::nodalScalars Foam::capsule::oneSidedFit::fitted::vorticity() const
{
    return gradient[0].col(1) - gradient[1].col(0);
}


Foam::capsule::nodalVectors Foam::capsule::oneSidedFit::fitted::traction
(
    const nodalVectors& n,
    const scalar mu
) const
{
    return viscous(n, mu) - scaled(pressure(mu), n);
}
