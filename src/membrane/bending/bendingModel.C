/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "bendingModel.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(bendingModel, 0);
    defineRunTimeSelectionTable(bendingModel, dictionary);
    addToRunTimeSelectionTable(bendingModel, bendingModel, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::capsule::bendingModel> Foam::capsule::bendingModel::New
(
    const dictionary& dict
)
{
    const auto& table = *dictionaryConstructorTablePtr_;
    const word type(input::choice(dict, "type", table.sortedToc()));

    return autoPtr<bendingModel>(table[type](dict));
}
