/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "timeScheme.H"
#include "input.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- The scheme of a term, which must be one word
static word onlyWord
(
    const fvMesh& mesh,
    const dictionary& schemes,
    const word& term
)
{
    if (schemes.found(term))
    {
        input::tokens(schemes, term);
    }
    ITstream& is = mesh.ddtScheme(term);
    const word scheme(is);
    if (is.nRemainingTokens())
    {
        FatalErrorInFunction
            << "there is more after " << scheme << "; permitted: one of the"
            << " words Euler, backward, steadyState"
            << exit(FatalError);
    }
    return scheme;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::timeScheme::timeScheme
(
    const fvMesh& mesh,
    const word& term,
    const label nOld
)
:
    c(0),
    c0(0),
    c00(0)
{
    const dictionary& schemes = mesh.schemesDict().subDict("ddtSchemes");
    const word scheme
    (
        input::guarded
        (
            schemes, term, [&]() { return onlyWord(mesh, schemes, term); }
        )
    );
    const scalar dt = mesh.time().deltaTValue();

    if (scheme == "Euler" || (scheme == "backward" && nOld < 2))
    {
        c = c0 = 1/dt;
    }
    else if (scheme == "backward")
    {
        const scalar dt0 = mesh.time().deltaT0Value();
        c = (1 + dt/(dt + dt0))/dt;
        c00 = dt/(dt0*(dt + dt0));
        c0 = c + c00;
    }
    else if (scheme != "steadyState")
    {
        FatalIOErrorInFunction(schemes)
            << "Entry " << term << " is " << scheme
            << "; permitted: Euler, backward, steadyState (not for the"
            << " membranes)" << exit(FatalIOError);
    }
}
