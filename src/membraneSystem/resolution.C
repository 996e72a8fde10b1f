/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "resolution.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::resolution::resolution
(
    const fvMesh& mesh,
    const solvedDirections& directions,
    const PtrList<immersedBody>& parts
)
:
    directions_(directions),
    clearance_(mesh, directions),
    parts_(parts)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::capsule::resolution::sort(const label n)
{
    nesting_ = nesting(clearance_, samples());
    return nesting_.sort(n);
}


Foam::List<Foam::capsule::surfaceSamples>
Foam::capsule::resolution::samples() const
{
    List<surfaceSamples> result(parts_.size());
    forAll(parts_, i)
    {
        result[i] = clearance_.samples(parts_[i].presentSurface());
    }
    return result;
}


Foam::string Foam::capsule::resolution::obstacle
(
    const label i,
    const List<surfaceSamples>& samples,
    const scalar cells
) const
{
    const string boundary = clearance_.obstacle(samples[i].points(), cells);
    if (!boundary.empty())
    {
        return boundary;
    }
    for (label j = 0; j < i; ++j)
    {
        if
        (
            clearance_.meet
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


Foam::string Foam::capsule::resolution::predictedObstacle
(
    const PtrList<closedSurface>& predicted
) const
{
    List<surfaceSamples> samples(parts_.size());
    forAll(parts_, i)
    {
        samples[i] = clearance_.samples(predicted[i]);
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
