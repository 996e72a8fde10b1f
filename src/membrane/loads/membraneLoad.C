/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneLoad.H"
#include "input.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(membraneLoad, 0);
    defineRunTimeSelectionTable(membraneLoad, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::capsule::membraneLoad> Foam::capsule::membraneLoad::New
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const auto& table = *dictionaryConstructorTablePtr_;
    const word type(input::choice(dict, "type", table.sortedToc()));

    return autoPtr<membraneLoad>(table[type](dict, mesh));
}
