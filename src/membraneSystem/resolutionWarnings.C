/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "resolution.H"
#include "immersedMembrane.H"
#include "placedShape.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Warn of a membrane that does not keep its area as its law promises
static void warnOfStrain
(
    const Foam::capsule::immersedBody& part,
    const Foam::capsule::closedSurface& surface
)
{
    using namespace Foam;

    if (!isA<capsule::immersedMembrane>(part))
    {
        return;
    }
    const capsule::membrane& m =
        refCast<const capsule::immersedMembrane>(part).body();
    const scalar permitted = m.largestStrain();
    if (permitted > 1)
    {
        return;
    }
    const capsule::membraneMechanics::principalValues p = m.principal(surface);
    const scalar strain = (p.l1.array()*p.l2.array() - 1).abs().maxCoeff();
    if (strain > permitted)
    {
        WarningInFunction
            << "Membrane " << m.name() << " has changed its area locally by "
            << strain << ", in the plane its length, more than the "
            << permitted << " of its elastic law's entry largestStrain: an"
            << " areaModulus " << strain/permitted << " times as large keeps it"
            << endl;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::resolution::warnOfShape
(
    const immersedBody& part,
    const closedSurface& surface
) const
{
    const string name = part.called();
    solvedVector where;
    const scalar film = clearance_.film(surface, where);
    if (film < clearance::resolved)
    {
        WarningInFunction
            << "Two parts of " << name.c_str() << " are " << film
            << " cell widths apart at " << directions_.toPoint(where)
            << ", less than " << clearance::resolved
            << ": it is too thin there, or folded too closely, to be"
            << " resolved" << endl;
    }
    const scalar spacing = clearance_.spacing(surface);
    if (spacing > placedShape::widestSpacing)
    {
        WarningInFunction
            << "Points of " << name.c_str() << " are " << spacing
            << " cell widths apart, more than "
            << placedShape::widestSpacing
            << ": it is not resolved there; see its entry "
            << (directions_.spatial() ? "degree" : "points") << endl;
    }
}


void Foam::capsule::resolution::warnOfMomentumLayer
(
    const immersedBody& part
)
{
    const scalar thickness = part.momentumThickness();
    if (thickness < clearance::resolved)
    {
        WarningInFunction
            << "The motion of " << part.called().c_str()
            << " changes so fast that its momentum spreads over " << thickness
            << " cell widths of the thinner liquid, less than "
            << clearance::resolved << ": this layer, and the damping by it, are"
            << " not resolved" << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::resolution::warn() const
{
    List<surfaceSamples> samples(parts_.size());
    forAll(parts_, i)
    {
        const immersedBody& part = parts_[i];
        const closedSurface surface(part.presentSurface());
        samples[i] = clearance_.samples(surface);
        const string near = obstacle(i, samples, clearance::resolved);
        if (!near.empty())
        {
            WarningInFunction
                << part.titled().c_str() << " is closer than "
                << clearance::resolved << " cell widths to " << near.c_str()
                << ": the film there is not resolved" << endl;
        }
        warnOfShape(part, surface);
        warnOfStrain(part, surface);
        warnOfMomentumLayer(part);
    }
}
