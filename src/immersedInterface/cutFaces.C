/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "cutFaces.H"
#include "releases.H"
#include "hexMatcher.H"
#include "prismMatcher.H"
#include "wedgePolyPatch.H"
#include "HashSet.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::cutFaces::longest = 3;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Is a cell a prism at the axis of a wedge, a hexahedron with one side of no
//  width?
static bool atAxis(const fvMesh& mesh, const label celli)
{
    label nWedge = 0;
    for (const label facei : mesh.cells()[celli])
    {
        if (!mesh.isInternalFace(facei))
        {
            const polyBoundaryMesh& patches = mesh.boundaryMesh();
            if (isA<wedgePolyPatch>(patches[patches.whichPatch(facei)]))
            {
                ++nWedge;
            }
        }
    }
    return nWedge == 2 && prismMatcher().isA(mesh, celli);
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::cutFaces::checkCells() const
{
    const fvMesh& mesh = levelSet_.mesh();
    labelHashSet cut;
    List<string> wrong(Pstream::nProcs());
    string& mine = wrong[Pstream::myProcNo()];
    for (const cutLink& v : links_)
    {
        if (v.cell != -1 && cut.insert(v.cell) && mine.empty())
        {
            const string refused = refusal(mesh, v.cell);
            if (!refused.empty())
            {
                OStringStream message;
                message
                    << "Membrane " << levelSet_.name() << " cuts cell "
                    << v.cell << " at " << mesh.cellCentres()[v.cell]
                    << ", which " << refused.c_str() << nl
                    << "    Cells at a membrane must be orthogonal hexahedra,"
                    << " at most " << longest << " times longer than wide.";
                mine = message.str();
            }
        }
    }

    // On all processors alike, for those who go on from it
    if (returnReduce(!mine.empty(), orOp<bool>()))
    {
        allGatherList(wrong);
        for (const string& message : wrong)
        {
            if (!message.empty())
            {
                FatalErrorInFunction << message.c_str() << exit(FatalError);
            }
        }
    }
}


Foam::scalar Foam::capsule::cutFaces::crossing
(
    const vector2& centre,
    const vector2& end,
    const scalar atCentre,
    const scalar atEnd
) const
{
    // Regula falsi with halving (Illinois) on the signed distance
    scalar alpha;
    scalar a = 0, b = 1, fa = atCentre, fb = atEnd, xi = 0;
    for (label iter = 0; iter < 30; ++iter)
    {
        xi = (a*fb - b*fa)/(fb - fa);
        const scalar f =
            levelSet_.signedDistance(centre + xi*(end - centre), alpha);
        if (mag(f) < 1e-10*levelSet_.width())
        {
            break;
        }
        if (f*fb < 0)
        {
            a = b;
            fa = fb;
        }
        else
        {
            fa *= 0.5;
        }
        b = xi;
        fb = f;
    }
    return xi;
}


void Foam::capsule::cutFaces::addFarSidePart
(
    const label facei,
    const vector2& centre,
    const vector2& end,
    const scalar atCentre,
    const scalar side,
    const scalar area
)
{
    scalar alpha;
    const scalar atEnd = levelSet_.signedDistance(end, alpha);
    const bool centreFar = (atCentre*side < 0);
    const bool endFar = (atEnd*side < 0);
    if (!centreFar && !endFar)
    {
        return;
    }

    scalar from = 0;
    scalar to = 1;
    if (centreFar != endFar)
    {
        (endFar ? from : to) = crossing(centre, end, atCentre, atEnd);
    }

    // Two-point Gauss rule, over the thickness of the mesh
    const scalar length = 0.5*(to - from)*(end - centre).norm();
    for (const scalar gauss : {-1/Foam::sqrt(3.0), 1/Foam::sqrt(3.0)})
    {
        const scalar xi = 0.5*(from + to + gauss*(to - from));
        const vector2 x = centre + xi*(end - centre);
        farSideDepths_.append(levelSet_.signedDistance(x, alpha));
        farSideAlphas_.append(alpha);
        farSideParts_.append
        ({
            facei, -length*levelSet_.plane().thickness(x)/area*side
        });
    }
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
    const label P = levelSet_.inBand(mesh.faceOwner()[facei]);
    label N = -1;
    scalar atN = 0;
    scalar alpha = 0;
    if (mesh.isInternalFace(facei))
    {
        N = levelSet_.inBand(mesh.faceNeighbour()[facei]);
    }
    else
    {
        N = levelSet_.cells().size() + acrossAlphas_.size();
        atN = levelSet_.signedDistance
        (
            levelSet_.image(cellSearch::New(mesh).beyond(facei)), alpha
        );
    }
    if (P == -1 || N == -1)
    {
        // Not at the membrane
        return;
    }
    const auto sideOf = [&](const scalar distance)
    {
        return distance < 0 ? -1 : 1;
    };
    const scalar sideP = sideOf(levelSet_.distance()(P));
    const scalar sideN =
        sideOf(mesh.isInternalFace(facei) ? levelSet_.distance()(N) : atN);

    scalar atFoot;
    const vector2 centre = levelSet_.plane()(mesh.faceCentres()[facei]);
    scalar atCentre = levelSet_.signedDistance(centre, atFoot);
    if (mag(atCentre) < 1e-10*levelSet_.width())
    {
        // The two halves of a coupled face must agree, whatever the round-off
        atCentre = 0;
    }
    const scalar side = (sideP == sideN ? sideP : atCentre < 0 ? -1 : 1);

    if (sideP != sideN)
    {
        if (!mesh.isInternalFace(facei))
        {
            acrossAlphas_.append(alpha);
            acrossDepths_.append(atN);
        }
        addLinks(facei, P, N, sideP, side);
        centreAlphas_.append(atFoot);
        centreDepths_.append(atCentre);
    }

    // From the centre to each end at most one crossing is looked for
    const Pair<vector2> ends
    (
        levelSet_.plane().ends(mesh.points(), mesh.faces()[facei])
    );
    for (const vector2& end : ends)
    {
        addFarSidePart
        (
            facei, centre, end, atCentre, side, mag(mesh.faceAreas()[facei])
        );
    }
}


Foam::capsule::jumpConditions::footPoints Foam::capsule::cutFaces::footPoints
(
    const UList<scalar>& alphas,
    const UList<scalar>& depths
) const
{
    return jumpConditions::footPoints
    (
        levelSet_.curve(),
        Eigen::Map<const nodalScalars>(alphas.cdata(), alphas.size()),
        Eigen::Map<const nodalScalars>(depths.cdata(), depths.size())
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::cutFaces::cutFaces(const membraneLevelSet& levelSet)
:
    levelSet_(levelSet)
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
    const label nAcross = acrossAlphas_.size();
    nodalScalars alphas(nBand + nAcross);
    nodalScalars depths(nBand + nAcross);
    alphas <<
        levelSet_.alpha(),
        Eigen::Map<const nodalScalars>(acrossAlphas_.cdata(), nAcross);
    depths <<
        levelSet_.distance(),
        Eigen::Map<const nodalScalars>(acrossDepths_.cdata(), nAcross);

    return jumpConditions::footPoints(levelSet_.curve(), alphas, depths);
}


Foam::capsule::jumpConditions::footPoints
Foam::capsule::cutFaces::ownersNeighbours() const
{
    const label nBand = levelSet_.cells().size();
    DynamicList<scalar> alphas;
    DynamicList<scalar> depths;
    for (const label i : owners_)
    {
        const label n = links_[i].neighbour;
        const bool across = (n >= nBand);
        alphas.append
        (
            across ? acrossAlphas_[n - nBand] : levelSet_.alpha()(n)
        );
        depths.append
        (
            across ? acrossDepths_[n - nBand] : levelSet_.distance()(n)
        );
    }
    return footPoints(alphas, depths);
}


Foam::string Foam::capsule::cutFaces::refusal
(
    const fvMesh& mesh,
    const label celli
)
{
    if (!hexMatcher().isA(mesh, celli) && !atAxis(mesh, celli))
    {
        return "is not a hexahedron";
    }
    for (const label facei : mesh.cells()[celli])
    {
        if (!mesh.isInternalFace(facei))
        {
            const polyBoundaryMesh& patches = mesh.boundaryMesh();
            if
            (
                !solvedDirections::cutsPlane
                (
                    patches[patches.whichPatch(facei)]
                )
            )
            {
                continue;
            }
        }
        const vector s = normalised(mesh.faceAreas()[facei]);
        const vector d =
            normalised(mesh.faceCentres()[facei] - mesh.cellCentres()[celli]);
        if (mag(s & d) < 1 - 1e-6)
        {
            return "is not orthogonal";
        }
    }
    const scalar ratio = cellSearch::New(mesh).ofCell(celli).ratio();
    if (ratio > longest*(1 + 1e-6))
    {
        return "is " + Foam::name(ratio) + " times longer than wide";
    }
    return string::null;
}
