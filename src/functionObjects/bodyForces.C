/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "bodyForces.H"
#include "membraneSystem.H"
#include "rigidBody.H"
#include "surfaceVtk.H"
#include "input.H"
#include "releases.H"
#include "unitConversion.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(bodyForces, 0);
    addToRunTimeSelectionTable(functionObject, bodyForces, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<const char*> Foam::functionObjects::bodyForces::columns() const
{
    if (membranes().directions().axisymmetric())
    {
        return {"x", "U", "forceX"};
    }
    if (membranes().directions().spatial())
    {
        return
        {
            "x", "y", "z", "angleX", "angleY", "angleZ", "U", "V", "W",
            "angularVelocityX", "angularVelocityY", "angularVelocityZ",
            "forceX", "forceY", "forceZ", "torqueX", "torqueY", "torqueZ"
        };
    }
    return
    {
        "x", "y", "angle", "U", "V", "angularVelocity", "forceX", "forceY",
        "torque"
    };
}


void Foam::functionObjects::bodyForces::writeRow
(
    const capsule::rigidBody& body,
    Ostream& os
)
{
    const capsule::rigidShape& shape = body.shape();
    const capsule::rigidShape::place place = body.place();
    const capsule::nodalScalars angle =
        shape.displacement(shape.start(), place).tail(shape.nRotations())
       *radToDeg(1.0);
    const auto writeAll = [&](const capsule::nodalScalars& values)
    {
        for (label i = 0; i < values.size(); ++i)
        {
            os  << tab << values(i);
        }
    };

    os  << mesh_.time().timeOutputValue();
    writeAll(place.centre.head(shape.nTranslations()).transpose());
    writeAll(angle);
    writeAll(body.velocity());
    const capsule::nodalScalars force = body.fluidForce();
    writeAll(force);
    os  << endl;
    if (force.hasNaN())
    {
        warnOfUnknown(body);
    }
}


void Foam::functionObjects::bodyForces::warnOfUnknown
(
    const capsule::rigidBody& body
)
{
    if (!warned_)
    {
        WarningInFunction
            << "The force of the fluid on body " << body.name()
            << " is not known at time " << mesh_.time().timeName()
            << ", where there is no file uniform/momentumRate/" << body.name()
            << ": no step of capsuleFoam has written this time. It is written"
            << " as nan, here and at other such times" << endl;
        warned_ = true;
    }
}


void Foam::functionObjects::bodyForces::writeVtk
(
    const capsule::rigidBody& body
) const
{
    const capsule::interfaceState& now = body.history().now();
    capsule::surfaceVtk vtk
    (
        body.name(), body.presentSurface(), membranes().directions()
    );
    vtk.addVectors("velocity", now.velocity);
    vtk.addVectors("force", now.force);
    vtk.write(baseTimeDir(), baseFileDir()/name());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::bodyForces::bodyForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    systemFunction(name, runTime, dict),
    lines_(false),
    warned_(false)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::bodyForces::read(const dictionary& dict)
{
    warnOfOthers(dict, {"lines"});
    lines_ = capsule::input::getOrDefault<bool>(dict, "lines", false);
    return systemFunction::read(dict);
}


bool Foam::functionObjects::bodyForces::write()
{
    if (!Pstream::master())
    {
        return true;
    }

    const capsule::membraneSystem& system = membranes();
    if (files_.empty())
    {
        files_.setSize(system.nBodies());
        forAll(files_, i)
        {
            files_.set(i, newFileAtStartTime(system.body(i).name()));
            writeHead(files_[i], "Body " + system.body(i).name(), columns());
        }
    }
    forAll(files_, i)
    {
        writeRow(system.body(i), files_[i]);
        if (lines_)
        {
            writeVtk(system.body(i));
        }
    }
    return true;
}


// ************************************************************************* //
