/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meshBoundary.H"
#include "planarBoundary.H"
#include "spatialBoundary.H"
#include "bitSet.H"
#include "releases.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(meshBoundary, 0);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::capsule::meshBoundary::containsHere(const solvedVector& x) const
{
    const periodicImages& periodic = directions_.images();
    if (periodic.periods().empty())
    {
        return encloses(x);
    }
    for (const solvedVector& image : periodic.images(x, periodic.wrapped(x)))
    {
        if (encloses(image))
        {
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::solvedVector Foam::capsule::meshBoundary::middle
(
    const nodalVectors& points
)
{
    return 0.5*(points.colwise().minCoeff() + points.colwise().maxCoeff());
}


Foam::scalar Foam::capsule::meshBoundary::leastRoot(const scalar square)
{
    const scalar least = returnReduce(square, minOp<scalar>());
    return least < GREAT ? Foam::sqrt(least) : GREAT;
}


Foam::word Foam::capsule::meshBoundary::patchName(const label patchi) const
{
    const label found = returnReduce(patchi, maxOp<label>());
    return found < 0 ? word() : mesh_.boundaryMesh()[found].name();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::meshBoundary::meshBoundary(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, meshBoundary>(mesh),
    directions_(mesh)
{}


const Foam::capsule::meshBoundary& Foam::capsule::meshBoundary::New
(
    const fvMesh& mesh
)
{
    const meshBoundary* found =
        mesh.thisDb().cfindObject<meshBoundary>(typeName);
    if (found)
    {
        return *found;
    }

    meshBoundary* made = nullptr;
    if (solvedDirections(mesh).spatial())
    {
        made = new spatialBoundary(mesh);
    }
    else
    {
        made = new planarBoundary(mesh);
    }
    regIOobject::store(static_cast<GeometricMeshObject<fvMesh>*>(made));
    return *made;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::capsule::meshBoundary::contains(const solvedVector& x) const
{
    return returnReduce(containsHere(x), orOp<bool>());
}


Foam::label Foam::capsule::meshBoundary::firstOutside
(
    const nodalVectors& points
) const
{
    List<labelList> found(Pstream::nProcs());
    DynamicList<label> mine;
    for (label i = 0; i < points.rows(); ++i)
    {
        if (containsHere(points.row(i)))
        {
            mine.append(i);
        }
    }
    found[Pstream::myProcNo()] = mine;
    allGatherList(found);

    bitSet outside(points.rows(), true);
    for (const labelList& list : found)
    {
        outside.unset(list);
    }
    return outside.find_first();
}


Foam::labelList Foam::capsule::meshBoundary::nearestOnWalls
(
    const nodalVectors& points,
    const scalar reach,
    nodalVectors& feet
) const
{
    const label n = points.rows();
    nodalScalars square = nodalScalars::Constant(n, sqr(reach));
    nodalVectors here = nodalVectors::Zero(n, points.cols());
    nearestHere(points, square, here);

    // The same on all processors
    List<scalarList> found(Pstream::nProcs());
    nodalMatrix mine(n, 1 + points.cols());
    mine << square, here;
    found[Pstream::myProcNo()] =
        scalarList(SubList<scalar>(UList<scalar>(mine.data(), mine.size())));
    allGatherList(found);

    DynamicList<label> nodes;
    for (label i = 0; i < n; ++i)
    {
        scalar least = sqr(reach);
        for (const scalarList& theirs : found)
        {
            if (theirs[i] < least)
            {
                least = theirs[i];
                for (label j = 0; j < points.cols(); ++j)
                {
                    feet(nodes.size(), j) = theirs[(1 + j)*n + i];
                }
            }
        }
        if (least < sqr(reach))
        {
            nodes.append(i);
        }
    }
    return labelList(nodes);
}


// ************************************************************************* //
