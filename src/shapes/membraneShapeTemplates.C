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
    const char* where
)
{
    const string others
    (
        string(where) + " (a plane mesh, a wedge and space have their own)"
    );
    return
        table[input::choice(dict, "type", table.sortedToc(), others.c_str())];
}
