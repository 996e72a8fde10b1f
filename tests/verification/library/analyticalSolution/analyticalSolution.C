/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "analyticalSolution.H"
#include "IOdictionary.H"
#include "dimensionedScalar.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(analyticalSolution, 0);
    defineRunTimeSelectionTable(analyticalSolution, dictionary);

    static IOdictionary constantDictionary(const word& name, const fvMesh& mesh)
    {
        return IOdictionary
        (
            IOobject
            (
                name,
                mesh.time().constant(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        );
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolution::analyticalSolution
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    radius_(dict.get<scalar>("radius")),
    viscosity_(viscosity),
    density_(density),
    centre_(directions(dict.get<vector>("centre"))),
    drift_(directions(dict.getOrDefault<vector>("drift", Zero)))
{}


Foam::autoPtr<Foam::capsule::analyticalSolution>
Foam::capsule::analyticalSolution::New(const fvMesh& mesh)
{
    const IOdictionary dict(constantDictionary("analyticalSolution", mesh));
    const IOdictionary transport
    (
        constantDictionary("transportProperties", mesh)
    );
    const IOdictionary membranes
    (
        constantDictionary("membraneProperties", mesh)
    );
    // The first is that of the solution, others are in it
    const dictionary& all = membranes.subDict("membranes");
    if (all.empty())
    {
        FatalIOErrorInFunction(all)
            << "An analytical solution needs a membrane"
            << exit(FatalIOError);
    }

    const word type(dict.get<word>("type"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "analytical solution",
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }

    return cstrIter()
    (
        dict,
        solvedDirections(mesh),
        Pair<scalar>
        (
            all.subDict(all.toc()[0]).get<scalar>("viscosity"),
            transport.get<scalar>("mu")
        ),
        transport.get<scalar>("rho")
    );
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

bool Foam::capsule::analyticalSolution::encloses
(
    const solvedVector& d,
    const scalar
) const
{
    return d.norm() < radius_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::solvedVector Foam::capsule::analyticalSolution::velocity
(
    const solvedVector& x,
    const scalar t
) const
{
    return
        drift_ + relativeFlow(relative(x, t), t, inside(x, t)).velocity;
}


Foam::capsule::nodalVectors Foam::capsule::analyticalSolution::force
(
    const closedSurface& surface,
    const scalar
) const
{
    return nodalVectors::Zero(surface.size(), surface.nComponents());
}
