/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.


\*---------------------------------------------------------------------------*/

#include "periodicImages.H"
#include "solvedDirections.H"
#include "releases.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Stop at a coupled patch that is not a translation
static void checkTranslation(const coupledPolyPatch& pp)
{
    if
    (
        !pp.parallel()
     || !(isA<cyclicPolyPatch>(pp) || isA<processorPolyPatch>(pp))
    )
    {
        FatalErrorInFunction
            << "The patch " << pp.name() << " of type " << pp.type()
            << " in " << pp.boundaryMesh().objectPath() << " couples"
            << (pp.parallel() ? " faces that do not match" : " by a rotation")
            << nl << "    Permitted: cyclic patches with a translation."
            << exit(FatalError);
    }
}


//- Separations of the coupled patches, of each processor
static List<List<vector>> separations(const fvMesh& mesh)
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
        checkTranslation(coupled);
        if (coupled.separated())
        {
            mine.append(coupled.separation()[0]);
        }
    }
    found[Pstream::myProcNo()] = mine;
    allGatherList(found);
    return found;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::periodicImages::periodicImages
(
    const fvMesh& mesh,
    const solvedDirections& directions
)
:
    centre_(directions(mesh.bounds().midpoint()))
{
    for (const List<vector>& list : separations(mesh))
    {
        for (const vector& v : list)
        {
            const solvedVector p =
                (directions(v).sum() < 0 ? -1 : 1)*directions(v);
            bool known = (p.norm() < 1e-12*mag(v));
            for (const solvedVector& q : periods_)
            {
                known =
                    known
                 || min((p - q).norm(), (p + q).norm()) < 1e-6*q.norm();
                if (!known && mag(p.dot(q)) > 1e-6*p.norm()*q.norm())
                {
                    FatalErrorInFunction
                        << "The cyclic patches in "
                        << mesh.boundaryMesh().objectPath() << " have the"
                        << " periods " << directions.toVector(p) << " and "
                        << directions.toVector(q)
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::solvedVector Foam::capsule::periodicImages::image
(
    const solvedVector& x,
    const solvedVector& centre
) const
{
    solvedVector result = x;
    for (const solvedVector& p : periods_)
    {
        result -= std::round((x - centre).dot(p)/p.squaredNorm())*p;
    }
    return result;
}


Foam::List<Foam::capsule::solvedVector> Foam::capsule::periodicImages::images
(
    const solvedVector& x,
    const solvedVector& centre
) const
{
    List<solvedVector> result(1, image(x, centre));
    for (const solvedVector& p : periods_)
    {
        const label n = result.size();
        for (const scalar side : {-1, 1})
        {
            for (label i = 0; i < n; ++i)
            {
                result.append(solvedVector(result[i] + side*p));
            }
        }
    }
    return result;
}


// ************************************************************************* //
