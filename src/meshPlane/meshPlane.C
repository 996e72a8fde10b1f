/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meshPlane.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::meshPlane::meshPlane(const fvMesh& mesh)
:
    first_(0),
    second_(1),
    across_(2),
    middle_(0),
    thickness_(0)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp))
        {
            FatalErrorInFunction
                << "The mesh has the wedge patch " << pp.name() << " in "
                << mesh.boundaryMesh().objectPath() << nl
                << "    Membranes need a plane two-dimensional mesh: two"
                << " opposite patches of type empty." << exit(FatalError);
        }
    }

    if (mesh.nGeometricD() != 2)
    {
        FatalErrorInFunction
            << "The mesh in " << mesh.boundaryMesh().objectPath() << " has "
            << mesh.nGeometricD() << " solved directions" << nl
            << "    Membranes need a plane two-dimensional mesh: two opposite"
            << " patches of type empty." << exit(FatalError);
    }

    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] == -1)
        {
            across_ = d;
        }
    }
    first_ = (across_ == 0 ? 1 : 0);
    second_ = (across_ == 2 ? 1 : 2);

    const boundBox& bounds = mesh.bounds();
    middle_ = bounds.midpoint()[across_];
    thickness_ = bounds.span()[across_];
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pointField Foam::capsule::meshPlane::toPoints(const nodalVectors& x) const
{
    pointField result(x.rows());
    forAll(result, i)
    {
        result[i] = toPoint(x.row(i));
    }
    return result;
}


Foam::vectorField Foam::capsule::meshPlane::toVectors
(
    const nodalVectors& v
) const
{
    vectorField result(v.rows());
    forAll(result, i)
    {
        result[i] = toVector(v.row(i));
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::meshPlane::toNodes
(
    const vectorField& v
) const
{
    nodalVectors result(v.size(), 2);
    forAll(v, i)
    {
        result.row(i) = (*this)(v[i]);
    }
    return result;
}
