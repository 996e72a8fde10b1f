/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneShape.H"

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

template<class Table>
typename Table::mapped_type Foam::capsule::membraneShape::constructor
(
    const dictionary& dict,
    const Table& table,
    const char* geometry
)
{
    const word type(input::get<word>(dict, "type"));
    if (!table.found(type))
    {
        FatalIOErrorInFunction(dict)
            << "Entry type is " << type << "; permitted in " << geometry << ": "
            << flatOutput(table.sortedToc()) << nl
            << "    A plane mesh, a wedge and space have shapes of their own"
            << exit(FatalIOError);
    }
    return table[type];
}
