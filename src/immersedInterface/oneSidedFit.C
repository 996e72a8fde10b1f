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
        const nodalMatrix fit = rows_[node].lazyProduct(f);
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


// ************************************************************************* //
