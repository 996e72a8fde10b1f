/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "extraPressureDrop.H"
#include "membraneSystem.H"
#include "rigidBody.H"
#include "input.H"
#include "IOdictionary.H"
#include "wallPolyPatch.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(extraPressureDrop, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        extraPressureDrop,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::functionObjects::extraPressureDrop::patch
(
    const dictionary& dict,
    const word& entry
) const
{
    const word name(capsule::input::get<word>(dict, entry));
    const label patchi = mesh_.boundaryMesh().findPatchID(name);
    if (patchi == -1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << name << ", which is no patch;"
            << " permitted: " << mesh_.boundaryMesh().names()
            << exit(FatalIOError);
    }
    if (gSum(mesh_.magSf().boundaryField()[patchi]) == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << name << ", a patch without faces"
            << " that the flow meets" << exit(FatalIOError);
    }
    return patchi;
}


void Foam::functionObjects::extraPressureDrop::readPatches
(
    const dictionary& dict
)
{
    const bool named = dict.found("inlet") || dict.found("outlet");
    if (membranes().fluid().driving().type() != capsule::drivingForce::typeName)
    {
        if (named)
        {
            FatalIOErrorInFunction(dict)
                << "Entries inlet and outlet are not for a flow that"
                << " constant/drivingForce drives; without them the drop is"
                << " that over the period of the mesh" << exit(FatalIOError);
        }
        if (membranes().directions().images().periods().size() != 1)
        {
            FatalIOErrorInFunction(dict)
                << "Entry type: " << type() << " of a driven flow needs a mesh"
                << " that is periodic in one direction" << exit(FatalIOError);
        }
        checkAtRest(dict);
        return;
    }

    if (!named && membranes().directions().images().periods().size())
    {
        FatalIOErrorInFunction(dict)
            << "Entries inlet and outlet are missing; only a flow that"
            << " constant/drivingForce drives goes without them"
            << exit(FatalIOError);
    }
    inlet_ = patch(dict, "inlet");
    outlet_ = patch(dict, "outlet");
    checkAtRest(dict);
    if (inlet_ == outlet_)
    {
        FatalIOErrorInFunction(dict)
            << "Entries inlet and outlet are the same patch; they must differ"
            << exit(FatalIOError);
    }
}


Foam::vector Foam::functionObjects::extraPressureDrop::period() const
{
    const capsule::solvedDirections& directions = membranes().directions();
    return directions.toVector(directions.images().periods()[0]);
}


Foam::scalar Foam::functionObjects::extraPressureDrop::drop
(
    const volScalarField& p
) const
{
    const auto average = [&](const label patchi)
    {
        const scalarField& area = mesh_.magSf().boundaryField()[patchi];
        return gSum(p.boundaryField()[patchi]*area)/gSum(area);
    };
    return average(inlet_) - average(outlet_);
}


Foam::scalar Foam::functionObjects::extraPressureDrop::flux
(
    const volVectorField& U
) const
{
    const vector e = period();
    return
        (e & gSum(vectorField(mesh_.V().field()*U.primitiveField())))
       /magSqr(e);
}


void Foam::functionObjects::extraPressureDrop::checkAtRest
(
    const dictionary& dict
) const
{
    // The reciprocal theorem is that of boundaries without power of their own
    const auto& U = mesh_.lookupObject<volVectorField>("U");
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& boundary = U.boundaryField()[patchi];
        const bool counts =
            boundary.fixesValue()
         && (driven() || isA<wallPolyPatch>(boundary.patch().patch()));
        if (counts && gSum(mag(boundary)) > 0)
        {
            FatalIOErrorInFunction(dict)
                << "Entry type: " << type() << " needs "
                << (driven() ? "boundaries" : "walls") << " at rest, but "
                << boundary.patch().name() << " moves, see " << U.objectPath()
                << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::functionObjects::extraPressureDrop::equivalentPower
(
    const capsule::closedSurface& surface,
    const capsule::oneSidedFit& fit,
    const capsule::nodalVectors& force
) const
{
    const capsule::nodalVectors u0 =
        fit.smooth(*emptyU_, *emptyp_).value.leftCols(surface.nComponents());

    return
       -membranes().directions().sector()
       *surface.integral(capsule::dot(force, u0));
}


Foam::scalar Foam::functionObjects::extraPressureDrop::extraDrop() const
{
    const capsule::membraneSystem& system = membranes();

    using capsule::dot;
    using capsule::nodalVectors;

    // Mean gradient of the empty channel, which its pressure is without
    const capsule::solvedVector mean = system.directions()
    (
        driven()
      ? vector(-emptyDrop_/magSqr(period())*period())
      : vector(Zero)
    );


    scalar power = 0;
    for (label i = 0; i < system.nMembranes(); ++i)
    {
        const capsule::membrane& m = system[i];
        const capsule::closedSurface surface(m.basis(), m.now().interface);
        if (system.oneViscosity(i))
        {
            // The equivalent force says the same; the velocity would have to be
            // known to 1/lambda of it
            power += equivalentPower(surface, system.fit(i), m.now().force);
            continue;
        }
        const nodalVectors& n = surface.normal();
        const nodalVectors F = m.force(m.surface(), surface.areaElement());

        // No net flux, so that the level of the pressure has no weight
        nodalVectors U = m.now().velocity;
        U -= surface.integral(dot(U, n))/surface.area()*n;

        const capsule::oneSidedFit::fitted empty =
            system.fit(i).smooth(*emptyU_, *emptyp_);
        nodalVectors traction = empty.traction(n, mu_);
        traction -= capsule::scaled
        (
            (surface.nodes().rowwise() - surface.centroid())*mean.transpose(),
            n
        );

        power +=
            system.directions().sector()
           *surface.integral
            (
                (m.viscosity() - system.outerViscosity(i))/mu_
               *dot(U, traction)
              - dot(F, empty.value.leftCols(surface.nComponents()))
            );
    }
    for (label i = 0; i < system.nBodies(); ++i)
    {
        const capsule::rigidBody& body = system.body(i);
        power += equivalentPower
        (
            body.surface(), body.fit(), body.history().now().force
        );
    }
    return power/flux_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::extraPressureDrop::extraPressureDrop
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    systemFunction(name, runTime, dict, typeName),
    inlet_(-1),
    outlet_(-1),
    mu_(0),
    emptyDrop_(0),
    flux_(0)
{
    read(dict);

    writeHead
    (
        file(),
        "Pressure drop [Pa]",
        List<const char*>{"drop", "emptyDrop", "extraDrop"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::extraPressureDrop::read(const dictionary& dict)
{
    readPatches(dict);
    warnOfOthers(dict, {"inlet", "outlet"});
    return systemFunction::read(dict);
}


bool Foam::functionObjects::extraPressureDrop::write()
{
    if (!emptyU_.valid())
    {
        solveEmpty();
    }
    scalar now = 0;
    scalar empty = emptyDrop_;
    if (driven())
    {
        now = membranes().fluid().driving().force() & period();
        empty *= flux(mesh_.lookupObject<volVectorField>("U"))/flux_;
    }
    else
    {
        now = drop(mesh_.lookupObject<volScalarField>("p"));
    }
    const scalar extra = extraDrop();
    if (Pstream::master())
    {
        file()
            << mesh_.time().timeOutputValue() << tab << now
            << tab << empty << tab << extra << endl;
    }
    return true;
}
