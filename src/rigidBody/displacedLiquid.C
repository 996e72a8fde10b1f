/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "displacedLiquid.H"
#include "wholeFile.H"
#include "input.H"
#include "syncTools.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Bring values that have changed in the cells to the coupled patches
static void updateCoupled(volVectorField& U)
{
    typedef Pstream::commsTypes commsTypes;
    volVectorField::Boundary& patches = U.boundaryFieldRef();
    const label nRequests = Pstream::nRequests();
    for (fvPatchVectorField& Up : patches)
    {
        if (Up.coupled())
        {
            Up.initEvaluate(commsTypes::nonBlocking);
        }
    }
    Pstream::waitRequests(nRequests);
    for (fvPatchVectorField& Up : patches)
    {
        if (Up.coupled())
        {
            Up.evaluate(commsTypes::nonBlocking);
        }
    }
}


//- Where the rate of momentum in a body is written
static IOobject rateFile
(
    const word& body,
    const fvMesh& mesh,
    const IOobject::readOption read
)
{
    return IOobject
    (
        body,
        mesh.time().timeName(),
        "uniform/momentumRate",
        mesh.time(),
        read,
        IOobject::NO_WRITE,
        false
    );
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::displacedLiquid::images
(
    const pointField& points
) const
{
    nodalVectors result(points.size(), directions_.size());
    forAll(points, i)
    {
        result.row(i) = interface_.levelSet().image(points[i]);
    }
    return result;
}


Foam::labelList Foam::capsule::displacedLiquid::facesInside() const
{
    labelList inside(mesh_.nCells(), Zero);
    for (const label celli : interface_.levelSet().inside())
    {
        inside[celli] = 1;
    }
    labelList beyond;
    syncTools::swapBoundaryCellList(mesh_, inside, beyond);

    const label nInternal = mesh_.nInternalFaces();
    DynamicList<label> faces;
    for (label facei = 0; facei < nInternal; ++facei)
    {
        if (inside[mesh_.owner()[facei]] && inside[mesh_.neighbour()[facei]])
        {
            faces.append(facei);
        }
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        for (label i = 0; pp.coupled() && i < pp.size(); ++i)
        {
            const label facei = pp.start() + i;
            if (inside[pp.faceCells()[i]] && beyond[facei - nInternal])
            {
                faces.append(facei);
            }
        }
    }
    return labelList(std::move(faces));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::displacedLiquid::displacedLiquid
(
    const sharpInterface& interface,
    const rigidShape& shape,
    const solvedDirections& directions,
    const fvMesh& mesh
)
:
    interface_(interface),
    shape_(shape),
    directions_(directions),
    mesh_(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::displacedLiquid::advance(const solvedVector& centre)
{
    const labelUList& cells = interface_.levelSet().inside();
    const nodalVectors x = images(pointField(mesh_.C(), cells));
    nodalScalars volumes(cells.size());
    forAll(cells, i)
    {
        volumes(i) = mesh_.V()[cells[i]];
    }

    const label m = shape_.nModes();
    nodalMatrix modes(x.size(), m);
    weights_.resize(m, x.size());
    for (label k = 0; k < m; ++k)
    {
        const nodalVectors mode = shape_.mode(x, centre, k);
        modes.col(k) = stacked(mode);
        weights_.row(k) = stacked(scaled(volumes, mode)).transpose();
    }
    nodalMatrix counted = weights_*modes;
    for (label i = 0; i < counted.size(); ++i)
    {
        reduce(counted(i), sumOp<scalar>());
    }
    momentumOf_ =
        shape_.volumes(interface_.surface())
       *counted.completeOrthogonalDecomposition().pseudoInverse();
}


Foam::capsule::nodalScalars Foam::capsule::displacedLiquid::momentum
(
    const volVectorField& U
) const
{
    const labelUList& cells = interface_.levelSet().inside();
    nodalVectors u(cells.size(), directions_.size());
    forAll(cells, i)
    {
        u.row(i) = directions_(U[cells[i]]);
    }
    nodalScalars sum = weights_*stacked(u);
    for (label k = 0; k < sum.size(); ++k)
    {
        reduce(sum(k), sumOp<scalar>());
    }
    return momentumOf_*sum;
}


Foam::capsule::nodalScalars Foam::capsule::displacedLiquid::delayedRate
(
    const nodalScalars& momentum,
    const nodalScalars& V,
    const nodalScalars& flux
) const
{
    const Eigen::Matrix<scalar, 3, 1> delayed =
        (shape_.volumes(interface_.surface())*V - momentum).tail(3);
    const Eigen::Matrix<scalar, 3, 1> turning = flux.tail(3);
    nodalScalars result = nodalScalars::Zero(momentum.size());
    result.tail(3) = 0.5*turning.cross(delayed);
    return result;
}


void Foam::capsule::displacedLiquid::setRigid
(
    const solvedVector& centre,
    const nodalScalars& V,
    volVectorField& U,
    surfaceScalarField& phi
) const
{
    const labelUList& cells = interface_.levelSet().inside();
    const nodalVectors u =
        shape_.velocity(images(pointField(mesh_.C(), cells)), centre, V);
    forAll(cells, i)
    {
        U[cells[i]] = directions_.toVector(u.row(i));
    }
    updateCoupled(U);

    const labelList faces(facesInside());
    const nodalVectors uf = shape_.velocity
    (
        images(pointField(mesh_.faceCentres(), faces)), centre, V
    );
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    forAll(faces, i)
    {
        const label facei = faces[i];
        const scalar flux =
            directions_.toVector(uf.row(i)) & mesh_.faceAreas()[facei];
        if (facei < mesh_.nInternalFaces())
        {
            phi[facei] = flux;
        }
        else
        {
            const label patchi = patches.whichPatch(facei);
            phi.boundaryFieldRef()[patchi][facei - patches[patchi].start()] =
                flux;
        }
    }
}


void Foam::capsule::displacedLiquid::writeRate
(
    const word& body,
    const nodalScalars& rate
) const
{
    IOdictionary dict(rateFile(body, mesh_, IOobject::NO_READ));
    scalarField values(rate.size());
    forAll(values, k)
    {
        values[k] = rate(k);
    }
    dict.add("rate", values);
    writeAtomically(dict, IOstream::ASCII);
}


bool Foam::capsule::displacedLiquid::readRate
(
    const word& body,
    nodalScalars& rate
) const
{
    IOobject io(rateFile(body, mesh_, IOobject::MUST_READ));
    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        return false;
    }
    const IOdictionary dict(io);
    const scalarField values(input::get<scalarField>(dict, "rate"));
    if (values.size() != shape_.nModes())
    {
        FatalIOErrorInFunction(dict)
            << "Entry rate has " << values.size() << " numbers; permitted: "
            << shape_.nModes() << exit(FatalIOError);
    }
    rate = Eigen::Map<const nodalScalars>(values.cdata(), values.size());
    return true;
}


// ************************************************************************* //
