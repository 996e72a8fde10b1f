/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "interfaceHistory.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::interfaceHistory::advance
(
    const nodalVectors& nodes,
    const Time& runTime
)
{
    old_.setSize(min(old_.size() + 1, label(3)));
    for (label i = old_.size() - 1; i > 0; --i)
    {
        std::swap(old_[i], old_[i - 1]);
    }
    old_[0] = now_;
    now_.x = nodes;
    now_.interface = nodes;
    if (nOld() == 2)
    {
        const scalar ratio = runTime.deltaTValue()/runTime.deltaT0Value();
        const interfaceState& old = old_[0];
        const interfaceState& older = old_[1];

        now_.force += ratio*(old.force - older.force);
        now_.velocity += ratio*(old.velocity - older.velocity);
        now_.vorticity += ratio*(old.vorticity - older.vorticity);
        now_.pressure += ratio*(old.pressure - older.pressure);
    }
}


void Foam::capsule::interfaceHistory::restore()
{
    std::swap(now_, old_[0]);
    for (label i = 1; i < old_.size(); ++i)
    {
        std::swap(old_[i - 1], old_[i]);
    }
    old_.setSize(old_.size() - 1);
}


// ************************************************************************* //
