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
    const solvedDirections& plane,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    radius_(dict.get<scalar>("radius")),
    viscosity_(viscosity),
    density_(density),
    centre_(plane(dict.get<vector>("centre"))),
    drift_(plane(dict.getOrDefault<vector>("drift", Zero)))
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
    const dictionary& all = membranes.subDict("membranes");
    if (all.size() != 1)
    {
        FatalIOErrorInFunction(all)
            << "An analytical solution is that of one membrane, not of "
            << all.toc() << exit(FatalIOError);
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

Foam::scalar Foam::capsule::analyticalSolution::radius
(
    const scalar,
    const scalar
) const
{
    return radius_;
}


Foam::capsule::vector2 Foam::capsule::analyticalSolution::polarForce
(
    const scalar,
    const scalar
) const
{
    return vector2::Zero();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::capsule::analyticalSolution::inside
(
    const vector2& x,
    const scalar t
) const
{
    const vector2 d = relative(x, t);
    return d.norm() < radius(std::atan2(d(1), d(0)), t);
}


Foam::capsule::vector2 Foam::capsule::analyticalSolution::velocity
(
    const vector2& x,
    const scalar t
) const
{
    const vector2 d = relative(x, t);
    const scalar theta = std::atan2(d(1), d(0));
    const polarFlow u = flow(d.norm(), theta, t, inside(x, t));
    const scalar c = std::cos(theta);
    const scalar s = std::sin(theta);
    return drift_ + vector2(u.r*c - u.theta*s, u.r*s + u.theta*c);
}


Foam::scalar Foam::capsule::analyticalSolution::pressure
(
    const vector2& x,
    const scalar t,
    const bool in
) const
{
    const vector2 d = relative(x, t);
    return flow(d.norm(), std::atan2(d(1), d(0)), t, in).p;
}


Foam::capsule::vector2 Foam::capsule::analyticalSolution::force
(
    const vector2& x,
    const scalar t
) const
{
    const vector2 d = relative(x, t);
    return polarForce(std::atan2(d(1), d(0)), t);
}
