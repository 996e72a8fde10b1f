/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "diffuseMembrane.H"
#include "freeSpaceResponse.H"
#include "sphericalBasis.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(diffuseMembrane, 0);
    addToRunTimeSelectionTable(immersedMembrane, diffuseMembrane, dictionary);
}
}

const Foam::scalar Foam::capsule::diffuseMembrane::bandWidth_ = 3;
const Foam::scalar Foam::capsule::diffuseMembrane::forceWaves_ = 1.0;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::diffuseMembrane::phi(const scalar r)
{
    const scalar x = mag(r);

    return
        x < 1 ? (3 - 2*x + Foam::sqrt(1 + 4*x - 4*sqr(x)))/8
      : x < 2 ? (5 - 2*x - Foam::sqrt(max(-7 + 12*x - 4*sqr(x), scalar(0))))/8
      : 0;
}


void Foam::capsule::diffuseMembrane::place(const nodalVectors& nodes)
{
    levelSet_.reset
    (
        new membraneLevelSet
        (
            membrane_.name(),
            mesh_,
            directions_,
            closedSurface(membrane_.basis(), nodes),
            bandWidth_
        )
    );
    interface_.clear();
    fit_.clear();
    delta_ = evaluated(nodes);
    if (directions_.spatial())
    {
        setSpreading();
    }
}


void Foam::capsule::diffuseMembrane::setSpreading()
{
    // Closer than half a cell the spread force is smooth
    const sphericalBasis& basis = this->basis().spherical();
    const sphericalGrid grid
    (
        sphericalHarmonics(basis.grid().degree()),
        label(2*constant::mathematical::pi*surface().meanRadius()
           /levelSet_->width()) + 1,
        0
    );
    refined_ = grid.values()*basis.analysis();
    weights_ = grid.weights();
    spreading_ = evaluated(refined_*surface().nodes());
}


Foam::capsule::diffuseMembrane::pointsByCells
Foam::capsule::diffuseMembrane::evaluated(const nodalVectors& nodes) const
{
    const cellSearch& search = cellSearch::New(mesh_);
    const labelUList& cells = levelSet_->cells();
    std::vector<Eigen::Triplet<scalar>> entries;
    forAll(cells, i)
    {
        const solvedVector centre = levelSet_->image(mesh_.C()[cells[i]]);
        const cellSearch::size& size = search.ofCell(cells[i]);
        for (Eigen::Index k = 0; k < nodes.rows(); ++k)
        {
            const solvedVector r =
                size.components(centre - nodes.row(k))
               .cwiseQuotient(size.widths);
            if
            (
                r.cwiseAbs().maxCoeff() < 2
             && levelSet_->sees(nodes.row(k), centre)
            )
            {
                scalar value = 1;
                for (label j = 0; j < r.size(); ++j)
                {
                    value *= phi(r(j));
                }
                entries.emplace_back(k, i, value);
            }
        }
    }
    pointsByCells result(nodes.rows(), cells.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::diffuseMembrane::interpolate
(
    const volVectorField& U
) const
{
    const labelUList& cells = levelSet_->cells();
    nodalVectors local(cells.size(), directions_.size());
    forAll(cells, i)
    {
        local.row(i) = directions_(U[cells[i]]);
    }
    nodalVectors result = delta_*local;
    for (scalar& value : UList<scalar>(result.data(), result.size()))
    {
        reduce(value, sumOp<scalar>());
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::diffuseMembrane::diffuseMembrane
(
    const word& name,
    const dictionary& dict,
    const solvedDirections& directions,
    const fvMesh& mesh,
    const scalar density,
    const scalar viscosity
)
:
    immersedMembrane(name, dict, directions, mesh, density, viscosity)
{
    if (directions.axisymmetric())
    {
        FatalIOErrorInFunction(dict)
            << "Entry interface of coupling is diffuse, which is not for"
            << " wedges; permitted in a wedge: sharp" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::capsule::oneSidedFit& Foam::capsule::diffuseMembrane::fit() const
{
    if (!fit_.valid())
    {
        interface_.reset
        (
            new immersedInterface
            (
                membrane_.name(), mesh_, directions_, surface(), oneSidedFit::radius
            )
        );
        fit_.reset(new oneSidedFit(*interface_, -1));
    }
    return *fit_;
}


void Foam::capsule::diffuseMembrane::start(const volVectorField& U)
{
    interfaceState& now = membrane_.now();
    place(now.interface);
    if (membrane_.nOld() == 0)
    {
        now.velocity = interpolate(U);
    }
}


void Foam::capsule::diffuseMembrane::predict
(
    const closedSurface& predicted,
    const couplingMethod& method
)
{
    addMomentum();
    membrane_.history().advance(predicted.nodes(), mesh_.time());
    setFlowScheme();
    place(predicted.nodes());
    setMotion(predicted, method);
    if (!method.implicitStress())
    {
        membrane_.now().force =
            membrane_.force(predicted, surface().areaElement());
    }
}


void Foam::capsule::diffuseMembrane::setJacobians(const couplingMethod& method)
{
    // Shorter waves fade in the spreading
    const nodalFilter slow = levelSet().filter(surface(), forceWaves_);
    nodalMatrix response =
        freeSpaceResponse::singleLayer(surface(), 0.5*(1 + ratio_)*outerViscosity());
    const label n = basis().nPacked();
    for (label i = 0; i < basis().nComponents(); ++i)
    {
        response.middleRows(i*n, n) =
            basis().reduced(slow, i)*response.middleRows(i*n, n);
    }
    setResponse
    (
        method, nodalMatrix::Identity(nForce(), nForce()), response
    );
}


void Foam::capsule::diffuseMembrane::restore()
{
    membrane_.history().restore();
    immersedMembrane::restore();
    place(membrane_.now().interface);
}


void Foam::capsule::diffuseMembrane::addViscosity(volScalarField& mu) const
{
    if (!smeared())
    {
        return;
    }
    const scalar excess = (ratio_ - 1)*outerViscosity();
    for (const label celli : levelSet_->inside())
    {
        mu[celli] += excess;
    }
    forAll(levelSet_->cells(), i)
    {
        const label celli = levelSet_->cells()[i];
        const scalar d = levelSet_->distance()(i)/levelSet_->width();
        const solvedVector foot = surface().expand(levelSet_->feet()[i]).x;
        if
        (
            mag(d) < 1
         && levelSet_->sees(foot, levelSet_->image(mesh_.C()[celli]))
        )
        {
            const scalar pi = constant::mathematical::pi;
            const scalar inside = 0.5*(1 - d - Foam::sin(pi*d)/pi);
            mu[celli] += (inside - (d < 0 ? 1 : 0))*excess;
        }
    }
}


void Foam::capsule::diffuseMembrane::addSources
(
    flowEquations::sources& sources,
    const surfaceScalarField*,
    const volScalarField&
)
{
    const nodalVectors perParameters =
        scaled(surface().areaElement(), membrane_.now().force);
    const nodalVectors spread =
        directions_.spatial()
      ? nodalVectors
        (
            spreading_.transpose()
           *scaled(weights_, nodalVectors(refined_*perParameters))
        )
      : nodalVectors
        (
            delta_.transpose()*scaled(basis().weights(), perParameters)
        );

    forAll(levelSet_->cells(), i)
    {
        const label celli = levelSet_->cells()[i];
        sources.momentum[celli] +=
            directions_.toVector(spread.row(i))
           *(directions_.sector()/mesh_.V()[celli]);
    }
}
