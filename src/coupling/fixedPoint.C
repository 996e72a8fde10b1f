/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fixedPoint.H"
#include "familyEntries.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace couplingMethods
{
    defineTypeNameAndDebug(fixedPoint, 0);
    addToRunTimeSelectionTable(couplingMethod, fixedPoint, dictionary);
    static const familyEntries<couplingMethod> entries({"relaxation"});
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::couplingMethods::fixedPoint::fixedPoint(const dictionary& dict)
:
    couplingMethod(dict),
    relaxation_
    (
        input::getBetweenOrDefault<scalar>(dict, "relaxation", 1, 1e-6, 1)
    )
{}
