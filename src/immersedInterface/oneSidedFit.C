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
    const membraneLevelSet& distance = interface_.distance();
    const labelUList& cells = distance.cells();
    const label components = (p ? 3 : 2);

    // Values as the side sees them
    nodalMatrix local(cells.size(), components);
    forAll(cells, i)
    {
        const label celli = cells[i];
        const scalar cellSide = distance.side()[celli];
        const scalar beyond = (jumping && cellSide != side_ ? cellSide : 0);

        vector u = U[celli];
        if (beyond != 0)
        {
            u -= beyond*interface_.jumpU()[celli];
        }
        local.block<1, 2>(i, 0) = distance.plane()(u);

        if (p)
        {
            local(i, 2) =
                (*p)[celli]
              - (beyond != 0 ? beyond*interface_.jumpp()[celli] : 0);
        }
    }
    const nodalMatrix values = gather(local);

    const label n = stencils_.size();
    fitted result;
    result.value.resize(n, components);
    result.gradient[0].resize(n, components);
    result.gradient[1].resize(n, components);

    forAll(stencils_, node)
    {
        const labelList& stencil = stencils_[node];
        nodalMatrix f(stencil.size(), components);
        forAll(stencil, i)
        {
            f.row(i) = values.row(stencil[i]);
        }
        const nodalMatrix fit = rows_[node]*f;
        result.value.row(node) = fit.row(0);
        result.gradient[0].row(node) = fit.row(1);
        result.gradient[1].row(node) = fit.row(2);
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
    const membraneLevelSet& distance = interface.distance();
    const labelUList& cells = distance.cells();
    const closedCurve& curve = distance.curve();
    const scalar r = radius*distance.width();

    sizes_[Pstream::myProcNo()] = cells.size();
    allGatherList(sizes_);

    nodalMatrix local(cells.size(), 3);
    forAll(cells, i)
    {
        local.row(i).head<2>() =
            distance.image(distance.mesh().C()[cells[i]]);
        local(i, 2) = -side*distance.distance()(i)/distance.width();
    }
    const nodalMatrix centres = gather(local);

    stencils_.setSize(curve.size());
    rows_.setSize(curve.size());
    for (label node = 0; node < curve.size(); ++node)
    {
        DynamicList<label> near;
        for (label i = 0; i < centres.rows(); ++i)
        {
            const vector2 d =
                centres.row(i).head<2>() - curve.nodes().row(node);
            if (d.norm() < r && centres(i, 2) < reach)
            {
                near.append(i);
            }
        }
        if (near.size() < 12)
        {
            FatalErrorInFunction
                << "Only " << near.size() << " cells around the membrane at "
                << distance.plane().toPoint(curve.nodes().row(node))
                << ": the membrane has left the mesh or touches a wall"
                << exit(FatalError);
        }

        // Weighted least squares for the cubic polynomials in cell widths
        nodalMatrix basis(near.size(), 10);
        nodalScalars weight(near.size());
        forAll(near, i)
        {
            const vector2 d =
                (centres.row(near[i]).head<2>() - curve.nodes().row(node))
               /distance.width();
            basis.row(i) <<
                1, d(0), d(1), sqr(d(0)), d(0)*d(1), sqr(d(1)),
                pow3(d(0)), sqr(d(0))*d(1), d(0)*sqr(d(1)), pow3(d(1));
            const scalar beyond = max(centres(near[i], 2), scalar(0));
            weight(i) = sqr
            (
                (1 - d.squaredNorm()/sqr(radius))*(1 - sqr(beyond/reach))
            );
        }
        const nodalMatrix inverse =
            (weight.asDiagonal()*basis)
           .completeOrthogonalDecomposition().pseudoInverse();

        stencils_[node] = near;
        rows_[node] = inverse.topRows<3>()*weight.asDiagonal();
        rows_[node].bottomRows<2>() /= distance.width();
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
    return value.col(2) + mu*(gradient[0].col(0) + gradient[1].col(1));
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
