/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cutFaces.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::cutFaces::clear
(
    const label facei,
    const label P,
    const label N,
    const nodalVectors& corners
) const
{
    // The distance changes by no more than the way
    const fvMesh& mesh = levelSet_.mesh();
    const auto isClear = [&](const label celli, const scalar distance)
    {
        const solvedVector x =
            levelSet_.directions()(mesh.cellCentres()[celli]);
        return
            sqr(distance)
          > (corners.rowwise() - x).rowwise().squaredNorm().maxCoeff();
    };
    return
        isClear(mesh.faceOwner()[facei], levelSet_.distance()(P))
     || (
            mesh.isInternalFace(facei)
         && isClear(mesh.faceNeighbour()[facei], levelSet_.distance()(N))
        );
}


void Foam::capsule::cutFaces::addLinks
(
    const label facei,
    const label P,
    const label N,
    const scalar sideP,
    const scalar side
)
{
    const fvMesh& mesh = levelSet_.mesh();
    const bool internal = mesh.isInternalFace(facei);
    const scalar weight = value(mesh.weights(), facei);
    const auto addLink = [&](const cutLink& link)
    {
        if (link.ownsFace)
        {
            owners_.append(links_.size());
        }
        else
        {
            farSideLinks_.append(links_.size());
        }
        links_.append(link);
    };
    addLink
    ({
        mesh.faceOwner()[facei], N, facei, 1, sideP, side == sideP, 1 - weight
    });
    addLink
    ({
        internal ? mesh.faceNeighbour()[facei] : -1, P, facei, -1, -sideP,
        side != sideP, weight
    });
}


void Foam::capsule::cutFaces::add(const label facei)
{
    const fvMesh& mesh = levelSet_.mesh();
    const bool internal = mesh.isInternalFace(facei);
    const label P = levelSet_.inBand(mesh.faceOwner()[facei]);
    label N = levelSet_.cells().size() + acrossFeet_.size();
    scalar atN = 0;
    surfaceParameter footN(Zero);
    if (internal)
    {
        N = levelSet_.inBand(mesh.faceNeighbour()[facei]);
        atN = (N == -1 ? 0 : levelSet_.distance()(N));
    }
    else
    {
        atN = levelSet_.signedDistance
        (
            levelSet_.image(cellSearch::New(mesh).beyond(facei)), footN
        );
    }
    if (P == -1 || N == -1)
    {
        // Not at the membrane
        return;
    }
    const scalar sideP = (levelSet_.distance()(P) < 0 ? -1 : 1);
    const scalar sideN = (atN < 0 ? -1 : 1);
    const nodalVectors corners
    (
        levelSet_.directions().corners(mesh.points(), mesh.faces()[facei])
    );
    if (sideP == sideN && clear(facei, P, N, corners))
    {
        return;
    }

    faceParts::located centre
    (
        levelSet_, levelSet_.directions()(mesh.faceCentres()[facei])
    );
    if (mag(centre.distance) < 1e-10*levelSet_.width())
    {
        // The two halves of a coupled face must agree, whatever the round-off
        centre.distance = 0;
    }
    const scalar side =
        (sideP == sideN ? sideP : centre.distance < 0 ? -1 : 1);

    if (sideP != sideN)
    {
        if (!internal)
        {
            acrossFeet_.append(footN);
            acrossDepths_.append(atN);
        }
        addLinks(facei, P, N, sideP, side);
        centreFeet_.append(centre.foot);
        centreDepths_.append(centre.distance);
    }

    parts_.add(facei, centre, side);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::cutFaces::cutFaces(const membraneLevelSet& levelSet)
:
    levelSet_(levelSet),
    parts_(levelSet)
{
    // Faces of cells that are closer to the membrane than they are long, and
    // half as much again
    const fvMesh& mesh = levelSet.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const cellSearch& search = cellSearch::New(mesh);
    DynamicList<label> close;
    forAll(levelSet.cells(), i)
    {
        const label celli = levelSet.cells()[i];
        if (mag(levelSet.distance()(i)) < 1.5*search.ofCell(celli).largest())
        {
            for (const label facei : mesh.cells()[celli])
            {
                if
                (
                    mesh.isInternalFace(facei)
                 || patches[patches.whichPatch(facei)].coupled()
                )
                {
                    close.append(facei);
                }
            }
        }
    }
    Foam::inplaceUniqueSort(close);
    for (const label facei : close)
    {
        add(facei);
    }
    checkCells();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::jumpConditions::footPoints Foam::capsule::cutFaces::cells() const
{
    const label nBand = levelSet_.cells().size();
    const label nAcross = acrossFeet_.size();
    DynamicList<surfaceParameter> feet(levelSet_.feet());
    feet.append(acrossFeet_);
    nodalScalars depths(nBand + nAcross);
    depths <<
        levelSet_.distance(),
        Eigen::Map<const nodalScalars>(acrossDepths_.cdata(), nAcross);

    return jumpConditions::footPoints(levelSet_.surface(), feet, depths);
}


Foam::capsule::jumpConditions::orientedFootPoints
Foam::capsule::cutFaces::ownersNeighbours() const
{
    const label nBand = levelSet_.cells().size();
    DynamicList<surfaceParameter> feet;
    DynamicList<scalar> depths;
    for (const label i : owners_)
    {
        const label n = links_[i].neighbour;
        const bool across = (n >= nBand);
        feet.append(across ? acrossFeet_[n - nBand] : levelSet_.feet()[n]);
        depths.append
        (
            across ? acrossDepths_[n - nBand] : levelSet_.distance()(n)
        );
    }
    return footPoints<jumpConditions::orientedFootPoints>(feet, depths);
}


Foam::capsule::solvedVector Foam::capsule::cutFaces::acrossFace
(
    const label facei
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    const pointField& centres = cellSearch::New(mesh).centres();
    const solvedVector own = levelSet_.image(centres[mesh.faceOwner()[facei]]);
    const solvedVector other = levelSet_.image
    (
        mesh.isInternalFace(facei)
      ? centres[mesh.faceNeighbour()[facei]]
      : cellSearch::New(mesh).beyond(facei)
    );
    return other - own;
}


// ************************************************************************* //
