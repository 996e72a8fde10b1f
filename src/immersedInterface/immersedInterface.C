/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "immersedInterface.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::immersedInterface::volume
(
    const labelUList& cells
) const
{
    scalar sum = 0;
    for (const label celli : cells)
    {
        sum += levelSet_.mesh().V()[celli];
    }
    return returnReduce(sum, sumOp<scalar>());
}


void Foam::capsule::immersedInterface::addOnFace
(
    surfaceScalarField& field,
    const label facei,
    const scalar value
) const
{
    const polyBoundaryMesh& patches = levelSet_.mesh().boundaryMesh();
    if (facei < levelSet_.mesh().nInternalFaces())
    {
        field[facei] += value;
    }
    else
    {
        const label patchi = patches.whichPatch(facei);
        field.boundaryFieldRef()[patchi][facei - patches[patchi].start()] +=
            value;
    }
}


void Foam::capsule::immersedInterface::setFaces()
{
    // What linear interpolation to a face gets wrong of its average, in the
    // flux: n.(w (1 - w)/2 d d - M/2) : grad grad u, with d between the cell
    // centres and M the second moment of the face about its centre, for a face
    // e along the plane e e/12, in a wedge e e/12 (1 - (e.e_r)^2/(12 r^2)) with
    // r its middle, in space the sum for two sides e of a rectangle
    const fvMesh& mesh = levelSet_.mesh();
    const solvedDirections& directions = levelSet_.directions();
    const label n = faces_.farSideLinks().size();
    const label d = directions.size();
    normal_.resize(n, d);
    interpolationTensor_.resize(n, d*d);
    for (label i = 0; i < n; ++i)
    {
        const cutFaces::cutLink& v = faces_.links()[faces_.farSideLinks()[i]];
        const solvedVector S = directions(cutFaces::value(mesh.Sf(), v.face));
        normal_.row(i) = S.normalized();
        const solvedVector across = faces_.acrossFace(v.face);
        solvedTensor M =
            0.5*v.weight*(1 - v.weight)*across.transpose()*across;

        const nodalVectors corners =
            directions.corners(mesh.points(), mesh.faces()[v.face]);
        for (label k = 0; k < d - 1; ++k)
        {
            solvedVector along = corners.row(k + 1) - corners.row(k);
            if (directions.axisymmetric())
            {
                const scalar r = directions.radius(corners.colwise().mean());
                along *= Foam::sqrt(1 - sqr(along(1)/r)/12);
            }
            M -= along.transpose()*along/24;
        }
        interpolationTensor_.row(i) =
            Eigen::Map<const nodalScalars>(M.data(), d*d).transpose();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::immersedInterface::immersedInterface
(
    const word& name,
    const fvMesh& mesh,
    const solvedDirections& directions,
    const closedSurface& surface,
    const scalar bandWidth
)
:
    levelSet_(name, mesh, directions, surface, bandWidth),
    faces_(levelSet_),
    cells_(faces_.cells()),
    cutVolume_(0),
    insideVolume_(0),
    centres_(faces_.centres()),
    farSideParts_(faces_.farSidePoints()),
    owners_(faces_.ownersNeighbours())
{
    DynamicList<label> cut;
    for (const cutFaces::cutLink& v : faces_.links())
    {
        if (v.cell != -1)
        {
            cut.append(v.cell);
        }
    }
    Foam::inplaceUniqueSort(cut);
    cut_ = cut;
    cutVolume_ = volume(cut_);
    insideVolume_ = volume(levelSet_.inside());
    setFaces();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::capsule::immersedInterface::jumpU(const label celli) const
{
    const label i = levelSet_.inBand(celli);
    return i == -1 ? vector(Zero) : levelSet_.directions().toVector(U_.row(i));
}


void Foam::capsule::immersedInterface::setJumps(const jumpConditions& jumps)
{
    jumps.values(cells_, U_, p_);
    gradp_ = jumps.pressureGradient(owners_);
    farSideU_ = jumps.velocity(farSideParts_);
    interpolationError_ = dot
    (
        normal_, jumps.velocityCurvature(centres_, interpolationTensor_)
    );
}


Foam::vector Foam::capsule::immersedInterface::addLaplacian
(
    const scalar mu,
    const scalar scale,
    volVectorField& source
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    const surfaceScalarField& delta = mesh.nonOrthDeltaCoeffs();
    vector total(Zero);

    for (const cutFaces::cutLink& v : faces_.links())
    {
        if (v.cell != -1)
        {
            const vector flux =
                mu*cutFaces::value(delta, v.face)
               *cutFaces::value(mesh.magSf(), v.face)*v.side*seenU(v);
            source[v.cell] +=
                (v.side < 0 ? scale : 1)
               *flux/mesh.V()[v.cell];
            total += flux;
        }
    }
    return returnReduce(total, sumOp<vector>());
}


Foam::vector Foam::capsule::immersedInterface::addGradient
(
    volVectorField& gradient
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    vector total(Zero);
    for (const cutFaces::cutLink& v : faces_.links())
    {
        if (v.cell != -1)
        {
            const vector flux =
                v.sign*v.weight*v.side*p_(v.neighbour)
               *cutFaces::value(mesh.Sf(), v.face);
            gradient[v.cell] += flux/mesh.V()[v.cell];
            total += flux;
        }
    }
    return returnReduce(total, sumOp<vector>());
}


void Foam::capsule::immersedInterface::addGradient
(
    volTensorField& gradient
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    for (const cutFaces::cutLink& v : faces_.links())
    {
        if (v.cell != -1)
        {
            gradient[v.cell] +=
                v.sign*v.weight*v.side/mesh.V()[v.cell]
               *cutFaces::value(mesh.Sf(), v.face)*seenU(v);
        }
    }
}


void Foam::capsule::immersedInterface::addConvection
(
    const surfaceScalarField& flux,
    const scalar rho,
    const volScalarField& scale,
    volVectorField& source
) const
{
    for (const cutFaces::cutLink& v : faces_.links())
    {
        if (v.cell != -1)
        {
            source[v.cell] -=
                rho*scale[v.cell]*v.sign*cutFaces::value(flux, v.face)
               *v.weight*v.side*seenU(v)/levelSet_.mesh().V()[v.cell];
        }
    }
}


void Foam::capsule::immersedInterface::addForce
(
    const vector& force,
    volVectorField& source
) const
{
    for (const label celli : cut_)
    {
        source[celli] += force/cutVolume_;
    }
}


void Foam::capsule::immersedInterface::addFlux
(
    surfaceScalarField& flux,
    surfaceScalarField& pressureFlux
) const
{
    const fvMesh& mesh = levelSet_.mesh();

    forAll(faces_.owners(), i)
    {
        const cutFaces::cutLink& v = faces_.links()[faces_.owners()[i]];
        const vector& S = cutFaces::value(mesh.Sf(), v.face);
        const vector gradp = levelSet_.directions().toVector(gradp_.row(i));
        const scalar snGradp =
            v.sign*cutFaces::value(mesh.nonOrthDeltaCoeffs(), v.face)
           *p_(v.neighbour);

        addOnFace(flux, v.face, v.side*v.weight*(seenU(v) & S));
        addOnFace
        (
            pressureFlux,
            v.face,
            v.side*(v.weight*(gradp & S) - snGradp*mag(S))
        );
    }
    forAll(faces_.farSideParts(), i)
    {
        const faceParts::farSidePart& b = faces_.farSideParts()[i];
        const vector U = levelSet_.directions().toVector(farSideU_.row(i));
        addOnFace
        (
            flux, b.face, b.weight*(U & cutFaces::value(mesh.Sf(), b.face))
        );
    }
}


void Foam::capsule::immersedInterface::addInterpolationDivergence
(
    volScalarField& divergence
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    scalar total = 0;

    forAll(faces_.farSideLinks(), i)
    {
        const cutFaces::cutLink& v = faces_.links()[faces_.farSideLinks()[i]];
        if (v.cell != -1)
        {
            const scalar flux =
               -v.sign*v.side*interpolationError_(i)
               *cutFaces::value(mesh.magSf(), v.face);
            divergence[v.cell] += flux/mesh.V()[v.cell];
            total += flux;
        }
    }
    reduce(total, sumOp<scalar>());

    // The net source, of second order, is taken back inside
    for (const label celli : levelSet_.inside())
    {
        divergence[celli] -= total/insideVolume_;
    }
}
