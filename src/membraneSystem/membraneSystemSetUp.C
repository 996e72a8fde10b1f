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
    U_(U),
    pressure_(pressure),
    rho_(rho.value()),
    mu_(mu.value()),
    driving_(driving),
    nMembranes_(0),
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
    // Wrong time schemes stop here, before the first step
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

    readMembranes();
    readBodies();
    if (size())
    {
        nest();
        fields_.reset(new scaledFields(mesh_));
        setResidual();
    }
    bool scaled = false;
    for (immersedBody& m : parts_)
    {
        m.start(U_);
        scaled = scaled || m.scale() != 1;
        if (m.smeared())
        {
            fields_->sources.viscosity.reset
            (
                new volScalarField
                (
                    IOobject("viscosity", mesh_.time().timeName(), mesh_),
                    mesh_,
                    dimensionedScalar(dimPressure*dimTime, Zero)
                )
            );
        }
    }
    if (size())
    {
        setScale();
    }
    if (scaled)
    {
        scaledPressure_.reset(new volScalarField("pScaled", pressure));
        *scaledPressure_ *= fields_->scale;
        addDriven(*scaledPressure_, false);
    }
}


// ************************************************************************* //
