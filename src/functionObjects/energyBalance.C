/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "energyBalance.H"
#include "kineticEnergyRate.H"
#include "membraneSystem.H"
#include "rigidBody.H"
#include "input.H"
#include "fvc.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(energyBalance, 0);
    addToRunTimeSelectionTable(functionObject, energyBalance, dictionary);
}
}


const Foam::scalar Foam::functionObjects::energyBalance::rest_ = 1e-6;

const char* const Foam::functionObjects::energyBalance::notKnown_ = "nan";


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const char* Foam::functionObjects::energyBalance::unit() const
{
    // Before there are membranes, when it runs afterwards
    const capsule::solvedDirections directions(mesh_);

    return
        directions.axisymmetric() || directions.spatial()
      ? " [W]"
      : " [W/m]";
}


Foam::Pair<Foam::scalar> Foam::functionObjects::energyBalance::boundaries
(
    const volVectorField& U,
    const volTensorField& gradient,
    const volScalarField& viscosity,
    const scalar density
) const
{
    const auto& p = mesh_.lookupObject<volScalarField>("p");
    const volVectorField gradp(fvc::grad(p));

    Pair<scalar> result(0, 0);
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled())
        {
            continue;
        }
        const vectorField& S = patch.Sf();
        const vectorField& u = U.boundaryField()[patchi];
        const fvPatchScalarField& pp = p.boundaryField()[patchi];

        scalarField pressure(pp);
        if (!pp.fixesValue())
        {
            // The momentum equation of the cell, which needs the gradient, has
            // the cell's own value on this face: that value is the one as far
            // beyond the face as the cell's centre lies before it
            pressure -=
                (
                    gradp.boundaryField()[patchi].patchInternalField()
                  & patch.nf()
                )
               /patch.deltaCoeffs();
        }
        const vectorField traction
        (
            (
                2*viscosity.boundaryField()[patchi]
               *symm(gradient.boundaryField()[patchi])
              & S
            )
          - pressure*S
        );
        result.first() += sum(traction & u);
        result.second() += sum(0.5*density*magSqr(u)*(u & S));
    }

    // Once for all: ranks have no faces on some of the patches
    reduce(result.first(), sumOp<scalar>());
    reduce(result.second(), sumOp<scalar>());
    return result;
}


void Foam::functionObjects::energyBalance::takeWrittenBoundaries()
{
    // The solver's set-up may have updated the boundaries, which the step
    // had not
    const volVectorField written
    (
        IOobject
        (
            "U",
            mesh_.time().timeName(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_
    );
    mesh_.lookupObjectRef<volVectorField>("U").boundaryFieldRef() ==
        written.boundaryField();
}


void Foam::functionObjects::energyBalance::writeRow
(
    const FixedList<scalar, 7>& row,
    const bool known
)
{
    if (!Pstream::master())
    {
        return;
    }
    file() << mesh_.time().timeOutputValue();
    forAll(row, i)
    {
        file() << tab;
        // Kinetic energy and imbalance
        if (known || (i != 1 && i != 5))
        {
            file() << row[i];
        }
        else
        {
            file() << notKnown_;
        }
    }
    file() << endl;
}


Foam::Pair<Foam::scalar> Foam::functionObjects::energyBalance::bodiesPower
(
    const capsule::membraneSystem& system
)
{
    Pair<scalar> sum(0, 0);
    for (label i = 0; i < system.nMembranes(); ++i)
    {
        const capsule::closedSurface surface(system[i].surface());
        const capsule::nodalScalars power = system[i].power(surface);
        sum.first() += surface.integral(power);
        sum.second() += surface.integral(power.cwiseAbs());
    }
    for (label i = 0; i < system.nBodies(); ++i)
    {
        const capsule::rigidBody& body = system.body(i);
        const capsule::interfaceState& now = body.history().now();
        sum.first() += body.power();
        sum.second() += body.stepSurface().integral
        (
            capsule::nodalScalars
            (
                capsule::dot(now.force, now.velocity).cwiseAbs()
            )
        );
    }
    return sum;
}


Foam::scalar Foam::functionObjects::energyBalance::contactPower
(
    const capsule::membraneSystem& system
)
{
    scalar power = 0;
    if (system.hasContact())
    {
        const List<capsule::nodalVectors> forces(system.contactForces());
        for (label i = 0; i < system.nMembranes(); ++i)
        {
            power += system[i].surface().integral
            (
                capsule::nodalScalars
                (
                    capsule::dot(forces[i], system[i].now().velocity)
                )
            );
        }
    }
    return power;
}


void Foam::functionObjects::energyBalance::warnOfUnknown()
{
    if (!warned_)
    {
        WarningInFunction
            << "The rate of kinetic energy is not known at time "
            << mesh_.time().timeName() << ", where there is no file"
            << " uniform/kineticEnergyRate: no step of capsuleFoam has"
            << " written this time. It and the imbalance are written as "
            << notKnown_ << ", here and at other such times" << endl;
        warned_ = true;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::energyBalance::energyBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, typeName, dict),
    largestImbalance_(0),
    warned_(false)
{
    read(dict);

    file().precision(12);
    writeHeader(file(), string("Balance of mechanical energy") + unit());
    writeCommented(file(), "Time");
    for
    (
        const char* column :
        {
            "dissipation", "kineticEnergyRate", "boundaries", "membranes",
            "drivingForce", "imbalance", "contact"
        }
    )
    {
        writeTabbed(file(), column);
    }
    file() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::energyBalance::read(const dictionary& dict)
{
    capsule::input::warnOfOthers
    (
        dict,
        capsule::input::joined
        (
            capsule::input::functionObjectEntries(),
            {"largestImbalance"}
        )
    );
    largestImbalance_ = capsule::input::getBetweenOrDefault<scalar>
    (
        dict,
        "largestImbalance",
        0.1,
        capsule::input::smallest,
        capsule::input::largest
    );
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::energyBalance::execute()
{
    return true;
}


bool Foam::functionObjects::energyBalance::write()
{
    const auto& system =
        mesh_.lookupObject<capsule::membraneSystem>("membraneProperties");
    const auto& U = mesh_.lookupObject<volVectorField>("U");
    if (postProcess)
    {
        takeWrittenBoundaries();
    }
    const scalar sector = system.directions().sector();
    const scalarField& V = mesh_.V();

    const volTensorField gradient(system.velocityGradient());
    const volScalarField viscosity(system.viscosity());
    const Pair<scalar> boundary
    (
        boundaries(U, gradient, viscosity, system.density())
    );

    const scalar dissipation =
        gSum
        (
            2*viscosity.primitiveField()
           *magSqr(symm(gradient.primitiveField()))*V
        )/sector;
    scalar rate = 0;
    const bool known =
        !postProcess || capsule::kineticEnergyRate::read(mesh_, rate);
    if (!postProcess)
    {
        rate = capsule::kineticEnergyRate::ofStep(U, system.density());
    }
    const scalar kinetic = (rate + boundary.second())/sector;
    const scalar driving =
        (system.driving().force() & gSum(U.primitiveField()*V))/sector;
    const Pair<scalar> bodies(bodiesPower(system));
    const scalar contact = contactPower(system);

    const scalar stress = boundary.first()/sector;
    const scalar imbalance =
        stress + bodies.first() + contact + driving - dissipation - kinetic;
    const scalar fed =
        max(stress, 0) + max(bodies.first(), 0) + max(contact, 0)
      + max(driving, 0) + max(-kinetic, 0);

    writeRow
    (
        {
            dissipation, kinetic, stress, bodies.first(), driving, imbalance,
            contact
        },
        known
    );
    if (!known)
    {
        warnOfUnknown();
        return true;
    }
    if (mag(imbalance) > max(largestImbalance_*fed, rest_*bodies.second()))
    {
        WarningInFunction
            << "Power of " << imbalance
            << unit() << " is out of balance, but "
            << fed << " feed the flow: the mesh does not resolve it, or a"
            << " boundary condition follows the flow, which still changes"
            << endl;
    }
    return true;
}
