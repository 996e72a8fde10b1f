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
                rho_,
                mu_
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
        const word type(input::get<word>(coupling, "interface"));
        if (type != "sharp")
        {
            FatalIOErrorInFunction(coupling)
                << "Entry interface is " << type << "; permitted with bodies:"
                << " sharp" << exit(FatalIOError);
        }
    }
    for (const entry& e : dict)
    {
        checkIsDict(e, dict);
        parts_.append
        (
            new rigidBody
            (
                e.keyword(), e.dict(), directions_, mesh_, rho_, mu_
            )
        );
    }
}


void Foam::capsule::membraneSystem::nest()
{
    clearance_.reset(new clearance(mesh_, directions_));
    List<surfaceSamples> samples(parts_.size());
    forAll(parts_, i)
    {
        samples[i] = clearance_->samples(parts_[i].presentSurface());
    }
    nesting_ = nesting(*clearance_, samples);
    const labelList newPlace(nesting_.sort(nMembranes_));
    parts_.reorder(newPlace);
    inplaceReorder(newPlace, samples);

    forAll(parts_, i)
    {
        const dictionary& dict =
            subDict(i < nMembranes_ ? "membranes" : "bodies")
           .subDict(parts_[i].name());
        const label outer = nesting_.outer(i);
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
        const string near = obstacle(i, samples, clearance::least);
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
    UPtrList<interfaceResidual> residuals(size());
    UPtrList<immersedBody> bodies(size());
    forAll(parts_, i)
    {
        residuals.set(i, &parts_[i]);
        bodies.set(i, &parts_[i]);
    }
    contact_ = contact::New(*this, mesh_, directions_);
    if (contact_.valid())
    {
        contactResidual_.reset
        (
            new contactResidual(*contact_, residuals, bodies)
        );
    }
    else
    {
        residual_.reset(new combinedResidual(residuals));
    }
}


// ************************************************************************* //
