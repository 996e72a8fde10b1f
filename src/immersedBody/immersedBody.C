/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "immersedBody.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(immersedBody, 0);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::capsule::immersedBody::setFlowScheme()
{
    flowScheme_.reset(new timeScheme(mesh_, "ddt(U)", history().nOld()));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::immersedBody::immersedBody
(
    const dictionary& dict,
    const solvedDirections& directions,
    const fvMesh& mesh,
    const scalar density,
    const scalar viscosity
)
:
    levelSetWriter_(dict),
    mesh_(mesh),
    directions_(directions),
    around_(density, viscosity)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::capsule::immersedBody::called() const
{
    return kind() + " " + name();
}


Foam::string Foam::capsule::immersedBody::titled() const
{
    string title(called());
    title[0] = std::toupper(title[0]);
    return title;
}


Foam::capsule::solvedVector
Foam::capsule::immersedBody::pressureOrigin() const
{
    return
        outer()
      ? levelSet().image(directions_.toPoint(outer()->pressureOrigin()))
      : levelSet().centre();
}


Foam::capsule::closedSurface
Foam::capsule::immersedBody::predictedSurface() const
{
    return closedSurface(basis(), predicted());
}


Foam::scalar Foam::capsule::immersedBody::offset() const
{
    const interfaceState& now = history().now();

    return
        (now.x - now.interface).rowwise().norm().maxCoeff()
       /levelSet().width();
}


void Foam::capsule::immersedBody::write() const
{
    history().write(mesh_.time());
    levelSetWriter_.write(levelSet());
}


// ************************************************************************* //
