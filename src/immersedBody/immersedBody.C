/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "immersedBody.H"
#include "input.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(immersedBody, 0);
}
}

const Foam::Enum<Foam::capsule::immersedBody::levelSetWritten>
Foam::capsule::immersedBody::levelSetNames_
({
    { levelSetWritten::none, "none" },
    { levelSetWritten::near, "near" },
    { levelSetWritten::whole, "whole" },
});


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::capsule::immersedBody::setSurroundings()
{
    rho_ = density_*outerScale();
    mu_ = viscosity_*outerViscousScale();
}


void Foam::capsule::immersedBody::setFlowScheme()
{
    flowScheme_.reset(new timeScheme(mesh_, "ddt(U)", history().nOld()));
}


Foam::capsule::closedSurface
Foam::capsule::immersedBody::predictedSurface() const
{
    return closedSurface
    (
        basis(),
        predicted(mesh_.time().deltaTValue(), mesh_.time().deltaT0Value())
    );
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
    levelSet_(levelSetWritten::near),
    density_(density),
    viscosity_(viscosity),
    outer_(nullptr),
    mesh_(mesh),
    directions_(directions),
    rho_(density),
    mu_(viscosity)
{
    if (dict.found("levelSet"))
    {
        const word written(input::get<word>(dict, "levelSet"));
        if (!levelSetNames_.found(written))
        {
            FatalIOErrorInFunction(dict)
                << "Entry levelSet is " << written << "; permitted: "
                << flatOutput(levelSetNames_.toc()) << exit(FatalIOError);
        }
        levelSet_ = levelSetNames_[written];
    }
}


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
        outer_
      ? levelSet().image(directions_.toPoint(outer_->pressureOrigin()))
      : levelSet().centre();
}


Foam::scalar Foam::capsule::immersedBody::offset() const
{
    const interfaceState& now = history().now();

    return
        (now.x - now.interface).rowwise().norm().maxCoeff()
       /levelSet().width();
}


Foam::capsule::nodalVectors Foam::capsule::immersedBody::pointsOf
(
    const nodalScalars&
) const
{
    NotImplemented;
    return nodalVectors();
}


Foam::capsule::nodalMatrix Foam::capsule::immersedBody::pointsChange
(
    const nodalMatrix&
) const
{
    NotImplemented;
    return nodalMatrix();
}


Foam::capsule::nodalMatrix Foam::capsule::immersedBody::loaded
(
    const nodalMatrix&
) const
{
    NotImplemented;
    return nodalMatrix();
}


void Foam::capsule::immersedBody::write() const
{
    history().write(mesh_.time());
    if (levelSet_ == levelSetWritten::near)
    {
        levelSet().near()().write();
    }
    else if (levelSet_ == levelSetWritten::whole)
    {
        levelSet().whole()().write();
    }
}


// ************************************************************************* //
