/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneSystem.H"
#include "placedShape.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Warn of a membrane that does not keep its area as its law promises
static void warnOfStrain
(
    const Foam::capsule::membrane& m,
    const Foam::capsule::closedSurface& surface
)
{
    using namespace Foam;

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

Foam::string Foam::capsule::membraneSystem::obstacle
(
    const label i,
    const List<surfaceSamples>& samples,
    const scalar cells
) const
{
    const string boundary = clearance_->obstacle(samples[i].points(), cells);
    if (!boundary.empty())
    {
        return boundary;
    }
    for (label j = 0; j < i; ++j)
    {
        if
        (
            clearance_->meet
            (
                samples[i], samples[j], cells, nesting_.nested(i, j)
            )
        )
        {
            return parts_[j].called();
        }
    }
    return string::null;
}


Foam::string Foam::capsule::membraneSystem::predictedObstacle() const
{
    const Time& time = mesh_.time();
    List<surfaceSamples> samples(parts_.size());
    forAll(parts_, i)
    {
        samples[i] = clearance_->samples
        (
            closedSurface
            (
                parts_[i].basis(),
                parts_[i].predicted(time.deltaTValue(), time.deltaT0Value())
            )
        );
        const string near = obstacle(i, samples, clearance::least);
        if (!near.empty())
        {
            return
                parts_[i].called() + " comes closer than "
              + Foam::name(clearance::least) + " cell widths to " + near;
        }
    }
    return string::null;
}


void Foam::capsule::membraneSystem::warnOfResolution() const
{
    List<surfaceSamples> samples(parts_.size());
    forAll(parts_, i)
    {
        const string name = parts_[i].called();
        const closedSurface surface(parts_[i].presentSurface());
        samples[i] = clearance_->samples(surface);
        const string near = obstacle(i, samples, clearance::resolved);
        if (!near.empty())
        {
            WarningInFunction
                << parts_[i].titled().c_str() << " is closer than "
                << clearance::resolved << " cell widths to " << near.c_str()
                << ": the film there is not resolved" << endl;
        }
        solvedVector where;
        const scalar film = clearance_->film(surface, where);
        if (film < clearance::resolved)
        {
            WarningInFunction
                << "Two parts of " << name.c_str() << " are " << film
                << " cell widths apart at " << directions_.toPoint(where)
                << ", less than " << clearance::resolved
                << ": it is too thin there, or folded too closely, to be"
                << " resolved" << endl;
        }
        const scalar spacing = clearance_->spacing(surface);
        if (spacing > placedShape::widestSpacing)
        {
            WarningInFunction
                << "Points of " << name.c_str() << " are " << spacing
                << " cell widths apart, more than "
                << placedShape::widestSpacing
                << ": it is not resolved there; see its entry "
                << (directions_.spatial() ? "degree" : "points") << endl;
        }
        if (i < nMembranes_)
        {
            warnOfStrain((*this)[i], surface);
        }
        warnOfMomentumLayer(parts_[i]);
    }
}


void Foam::capsule::membraneSystem::warnOfMomentumLayer
(
    const immersedBody& part
) const
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


// ************************************************************************* //
