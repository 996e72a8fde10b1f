/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "contact.H"
#include "input.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::contact::reach_ = 1.5;
const Foam::scalar Foam::capsule::contact::leastRange_ = 1;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::contact::contact
(
    const dictionary& dict,
    const fvMesh& mesh,
    const solvedDirections& directions
)
:
    directions_(directions),
    boundary_(meshBoundary::New(mesh)),
    law_(dict),
    folds_(input::getOrDefault<bool>(dict, "folds", false))
{
    input::permit(dict, {"type", "range", "strength", "folds"});

    const scalar width = gMin(directions.widths(mesh)());
    if (law_.range() < leastRange_*width)
    {
        WarningInFunction
            << "The range of contact, " << law_.range() << " m, is less than "
            << leastRange_ << " cell widths, " << width << " m: membranes may"
            << " come closer than they can be placed before it holds them"
            << endl;
    }
}


Foam::autoPtr<Foam::capsule::contact> Foam::capsule::contact::New
(
    const dictionary& properties,
    const fvMesh& mesh,
    const solvedDirections& directions
)
{
    autoPtr<contact> made;
    if (properties.found("contact"))
    {
        const dictionary& dict = input::subDict(properties, "contact");
        if (input::choice(dict, "type", {"none", "repulsion"}) == "repulsion")
        {
            made.reset(new contact(dict, mesh, directions));
        }
    }
    return made;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::contact::energy
(
    const contactGaps& found,
    const nodalScalars& gaps
) const
{
    const auto perArea = [&](const scalar gap) { return law_.energy(gap); };
    return found.areas().dot(gaps.unaryExpr(perArea));
}


Foam::capsule::nodalScalars Foam::capsule::contact::forces
(
    const contactGaps& found,
    const nodalScalars& gaps
) const
{
    const auto perArea = [&](const scalar gap) { return law_.pressure(gap); };
    return found.areas().cwiseProduct(gaps.unaryExpr(perArea));
}


Foam::capsule::nodalScalars Foam::capsule::contact::stiffness
(
    const contactGaps& found,
    const nodalScalars& gaps
) const
{
    const auto perArea = [&](const scalar gap) { return law_.stiffness(gap); };
    return found.areas().cwiseProduct(gaps.unaryExpr(perArea));
}


Foam::List<Foam::capsule::nodalVectors> Foam::capsule::contact::forces
(
    const PtrList<closedSurface>& surfaces
) const
{
    const contactGaps found(find(surfaces));
    const nodalScalars acting = forces(found, found.gaps());

    List<nodalVectors> result(surfaces.size());
    forAll(surfaces, i)
    {
        const surfaceBasis& basis = surfaces[i].basis();
        const label n = basis.nComponents()*basis.nPacked();
        result[i] = contactGaps::perArea
        (
            basis,
            surfaces[i].areaElement(),
            found.derivatives(i, n)*acting
        );
    }
    return result;
}


// ************************************************************************* //
