/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneSystem.H"
#include "rigidBody.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Stop if an entry of a dictionary of membranes or bodies is none itself
static void checkIsDict(const Foam::entry& e, const Foam::dictionary& dict)
{
    if (!e.isDict())
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << e.keyword() << " is not a dictionary; "
            << dict.dictName() << " holds one dictionary for each of them"
            << Foam::exit(Foam::FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::membraneSystem::readMembranes()
{
    const dictionary& dict = input::subDict(*this, "membranes");
    for (const entry& e : dict)
    {
        checkIsDict(e, dict);
        parts_.append
        (
            immersedMembrane::New
            (
                subDict("coupling"),
                e.keyword(),
                e.dict(),
                directions_,
                mesh_,
                fluid_.density(),
                fluid_.outerViscosity()
            )
        );
        ++nMembranes_;
    }
}


void Foam::capsule::membraneSystem::readBodies()
{
    if (!found("bodies"))
    {
        return;
    }
    const dictionary& dict = input::subDict(*this, "bodies");
    const dictionary& coupling = subDict("coupling");
    if (dict.size() && coupling.found("interface"))
    {
        input::choice(coupling, "interface", {"sharp"}, " with bodies");
    }
    for (const entry& e : dict)
    {
        checkIsDict(e, dict);
        parts_.append
        (
            new rigidBody
            (
                e.keyword(),
                e.dict(),
                directions_,
                mesh_,
                fluid_.density(),
                fluid_.outerViscosity()
            )
        );
    }
}


void Foam::capsule::membraneSystem::nest()
{
    resolution_.reset(new resolution(mesh_, directions_, parts_));
    parts_.reorder(resolution_->sort(nMembranes_));
    const List<surfaceSamples> samples(resolution_->samples());

    forAll(parts_, i)
    {
        const dictionary& dict =
            subDict(i < nMembranes_ ? "membranes" : "bodies")
           .subDict(parts_[i].name());
        const label outer = resolution_->outer(i);
        if (outer >= nMembranes_ || (outer >= 0 && !parts_[i].forceFree()))
        {
            FatalIOErrorInFunction(dict)
                << parts_[i].titled().c_str() << " lies inside "
                << parts_[outer].called().c_str() << "; permitted"
                << " inside membranes: membranes without a load and free"
                << " bodies without a force; inside bodies: none"
                << exit(FatalIOError);
        }
        if (outer >= 0)
        {
            parts_[i].setOuter(parts_[outer]);
        }
        const string near =
            resolution_->obstacle(i, samples, clearance::least);
        if (!near.empty())
        {
            FatalIOErrorInFunction(dict)
                << parts_[i].titled().c_str() << " touches or crosses "
                << near.c_str() << nl
                << "    Membranes and bodies must lie inside the mesh, at least "
                << clearance::least << " cell widths from its boundaries and"
                << " from each other; see the entries "
                << flatOutput(dict.subDict("shape").toc()) << " of shape"
                << exit(FatalIOError);
        }
    }
}


void Foam::capsule::membraneSystem::setResidual()
{
    contact_ = contact::New(*this, mesh_, directions_);
    if (contact_.valid())
    {
        UPtrList<contactBody> bodies(size());
        forAll(parts_, i)
        {
            bodies.set(i, &parts_[i]);
        }
        contactResidual_.reset(new contactResidual(*contact_, bodies));
    }
    else
    {
        UPtrList<interfaceResidual> residuals(size());
        forAll(parts_, i)
        {
            residuals.set(i, &parts_[i]);
        }
        residual_.reset(new combinedResidual(residuals));
    }
}


// ************************************************************************* //
