/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneSystem.H"
#include "membraneNames.H"
#include "timeScheme.H"
#include "sigFpe.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::membraneSystem::checkSchemes() const
{
    input::warnOfOthers
    (
        mesh_.schemesDict().subDict("ddtSchemes"),
        {"default", "ddt(U)", "ddt(membranes)"}
    );
    timeScheme(mesh_, "ddt(U)", 0);
    if (timeScheme(mesh_, "ddt(membranes)", 0).c == 0)
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "Entry ddt(membranes) is steadyState; permitted: Euler,"
            << " backward" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneSystem::membraneSystem
(
    volVectorField& U,
    volScalarField& pressure,
    const dimensionedScalar& rho,
    const dimensionedScalar& mu,
    const drivingForce& driving
)
:
    IOdictionary
    (
        // Until the file is read: a number beyond the range of a scalar is an
        // error of the file, not a floating-point exception
        (
            sigFpe::ignore(),
            IOobject
            (
                "membraneProperties",
                U.time().constant(),
                U.mesh(),
                IOobject::MUST_READ_IF_MODIFIED,
                IOobject::NO_WRITE
            )
        )
    ),
    mesh_(U.mesh()),
    directions_(mesh_),
    nMembranes_(0),
    fluid_
    (
        parts_, directions_, U, pressure, rho.value(), mu.value(), driving
    ),
    method_
    (
        // Wrong names may have taken the rest of the file with them
        (
            membraneNames::check(*this),
            couplingMethod::New(input::subDict(*this, "coupling"))
        )
    ),
    stressTolerance_
    (
        input::getBetweenOrDefault<scalar>
        (
            subDict("coupling"), "stressTolerance", 1e-3, 1e-15, 1
        )
    ),
    displacementTolerance_
    (
        input::getBetweenOrDefault<scalar>
        (
            subDict("coupling"), "displacementTolerance", 1e-4, 1e-15, 1
        )
    ),
    maxIter_
    (
        input::getBetweenOrDefault<label>
        (
            subDict("coupling"), "maxIter", 30, 1, 10000
        )
    ),
    iter_(0),
    converged_(true),
    nMoved_(0),
    placed_(false)
{
    checkSchemes();
    readMembranes();
    readBodies();
    if (size())
    {
        nest();
        setResidual();
    }
    for (immersedBody& m : parts_)
    {
        m.start(fluid_.U());
    }
    fluid_.start();
}


// ************************************************************************* //
