/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "energyBudget.H"
#include "membraneSystem.H"
#include "rigidBody.H"
#include "fvc.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Power of the stress at the boundaries, and the flux of kinetic energy out of
//  them [W]
static Pair<scalar> atBoundaries
(
    const volVectorField& U,
    const volTensorField& gradient,
    const volScalarField& viscosity,
    const scalar density
)
{
    const fvMesh& mesh = U.mesh();
    const auto& p = mesh.lookupObject<volScalarField>("p");
    const volVectorField gradp(fvc::grad(p));

    Pair<scalar> result(0, 0);
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
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


//- Power of membranes and bodies, and the integral of its magnitude
static Pair<scalar> ofBodies(const membraneSystem& system)
{
    Pair<scalar> sum(0, 0);
    for (label i = 0; i < system.nMembranes(); ++i)
    {
        const closedSurface surface(system[i].surface());
        const nodalScalars power = system[i].power(surface);
        sum.first() += surface.integral(power);
        sum.second() += surface.integral(power.cwiseAbs());
    }
    for (label i = 0; i < system.nBodies(); ++i)
    {
        const rigidBody& body = system.body(i);
        const interfaceState& now = body.history().now();
        sum.first() += body.power();
        sum.second() += body.surface().integral
        (
            nodalScalars
            (
                dot(now.force, now.velocity).cwiseAbs()
            )
        );
    }
    return sum;
}


//- Power of the contact of the membranes
static scalar ofContact(const membraneSystem& system)
{
    scalar power = 0;
    if (system.hasContact())
    {
        const List<nodalVectors> forces(system.contactForces());
        for (label i = 0; i < system.nMembranes(); ++i)
        {
            power += system[i].surface().integral
            (
                nodalScalars
                (
                    dot(forces[i], system[i].now().velocity)
                )
            );
        }
    }
    return power;
}

}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::energyBudget::energyBudget
(
    const membraneSystem& system,
    const scalar rate
)
{
    const scaledFluid& fluid = system.fluid();
    const volVectorField& U = fluid.U();
    const scalarField& V = U.mesh().V();
    const scalar sector = system.directions().sector();

    const volTensorField gradient(fluid.velocityGradient());
    const volScalarField viscosity(fluid.viscosity());
    const Pair<scalar> boundary
    (
        atBoundaries(U, gradient, viscosity, fluid.density())
    );
    dissipation =
        gSum
        (
            2*viscosity.primitiveField()
           *magSqr(symm(gradient.primitiveField()))*V
        )/sector;
    kinetic = (rate + boundary.second())/sector;
    boundaries = boundary.first()/sector;
    driving = (fluid.driving().force() & gSum(U.primitiveField()*V))/sector;

    const Pair<scalar> bodies(ofBodies(system));
    membranes = bodies.first();
    exchanged = bodies.second();
    contact = ofContact(system);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::energyBudget::imbalance() const
{
    return boundaries + membranes + contact + driving - dissipation - kinetic;
}


Foam::scalar Foam::capsule::energyBudget::fed() const
{
    return
        max(boundaries, 0) + max(membranes, 0) + max(contact, 0)
      + max(driving, 0) + max(-kinetic, 0);
}
