/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "meshPlane.H"
#include "releases.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "volFields.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::meshPlane::setPeriods(const fvMesh& mesh)
{
    // In parallel a cyclic patch may have no faces here, or be a processor's
    List<List<vector>> found(Pstream::nProcs());
    DynamicList<vector> mine;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled() || pp.empty())
        {
            continue;
        }
        const auto& coupled = refCast<const coupledPolyPatch>(pp);
        if
        (
            !coupled.parallel()
         || !(isA<cyclicPolyPatch>(pp) || isA<processorPolyPatch>(pp))
        )
        {
            FatalErrorInFunction
                << "The patch " << pp.name() << " of type " << pp.type()
                << " in " << mesh.boundaryMesh().objectPath() << " couples"
                << (coupled.parallel() ? " faces that do not match" : " by a rotation")
                << nl << "    Permitted: cyclic patches with a translation."
                << exit(FatalError);
        }
        if (coupled.separated())
        {
            mine.append(coupled.separation()[0]);
        }
    }
    found[Pstream::myProcNo()] = mine;
    allGatherList(found);

    for (const List<vector>& list : found)
    {
        for (const vector& v : list)
        {
            const vector2 p =
                (v[first_] + v[second_] < 0 ? -1 : 1)*(*this)(v);
            bool known = false;
            for (const vector2& q : periods_)
            {
                known =
                    known
                 || min((p - q).norm(), (p + q).norm()) < 1e-6*q.norm();
                if (!known && mag(p.dot(q)) > 1e-6*p.norm()*q.norm())
                {
                    FatalErrorInFunction
                        << "The cyclic patches in "
                        << mesh.boundaryMesh().objectPath() << " have the"
                        << " periods " << toVector(p) << " and " << toVector(q)
                        << nl << "    Periods must be perpendicular."
                        << exit(FatalError);
                }
            }
            if (!known)
            {
                periods_.append(p);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::meshPlane::meshPlane(const fvMesh& mesh)
:
    first_(0),
    second_(1),
    across_(2),
    middle_(0),
    thickness_(0),
    centre_(vector2::Zero())
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

    label nEmpty = 0;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        nEmpty += (isA<emptyPolyPatch>(pp) ? pp.size() : 0);
    }
    if (nEmpty != 2*mesh.nCells())
    {
        FatalErrorInFunction
            << "The mesh in " << mesh.boundaryMesh().objectPath() << " has "
            << mesh.nCells() << " cells and " << nEmpty << " faces on patches"
            << " of type empty" << nl
            << "    A plane mesh is one cell thick: two such faces a cell."
            << exit(FatalError);
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
    centre_ = (*this)(bounds.midpoint());
    setPeriods(mesh);

    // Geometry that is made on demand, which takes all processors: later only
    // those that a membrane cuts would ask for it
    mesh.C();
    mesh.weights();
    mesh.nonOrthDeltaCoeffs();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::vector2 Foam::capsule::meshPlane::image
(
    const vector2& x,
    const vector2& centre
) const
{
    vector2 result = x;
    for (const vector2& p : periods_)
    {
        result -= std::round((x - centre).dot(p)/p.squaredNorm())*p;
    }
    return result;
}


Foam::List<Foam::capsule::vector2> Foam::capsule::meshPlane::images
(
    const vector2& x,
    const vector2& centre
) const
{
    List<vector2> result(1, image(x, centre));
    for (const vector2& p : periods_)
    {
        const label n = result.size();
        for (const scalar side : {-1, 1})
        {
            for (label i = 0; i < n; ++i)
            {
                result.append(vector2(result[i] + side*p));
            }
        }
    }
    return result;
}


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
