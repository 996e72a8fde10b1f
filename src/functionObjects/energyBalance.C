/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "energyBalance.H"
#include "energyBudget.H"
#include "kineticEnergyRate.H"
#include "membraneSystem.H"
#include "input.H"
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
    const capsule::energyBudget& budget,
    const bool known
)
{
    if (!Pstream::master())
    {
        return;
    }
    const auto writeIf = [&](const bool isKnown, const scalar value)
    {
        file() << tab;
        if (isKnown)
        {
            file() << value;
        }
        else
        {
            file() << notKnown_;
        }
    };
    file() << mesh_.time().timeOutputValue();
    writeIf(true, budget.dissipation);
    writeIf(known, budget.kinetic);
    writeIf(true, budget.boundaries);
    writeIf(true, budget.membranes);
    writeIf(true, budget.driving);
    writeIf(known, budget.imbalance());
    writeIf(true, budget.contact);
    file() << endl;
}


void Foam::functionObjects::energyBalance::warnOfImbalance
(
    const capsule::energyBudget& budget
) const
{
    const scalar fed = budget.fed();
    const scalar imbalance = budget.imbalance();
    if (mag(imbalance) > max(largestImbalance_*fed, rest_*budget.exchanged))
    {
        WarningInFunction
            << "Power of " << imbalance
            << unit() << " is out of balance, but "
            << fed << " feed the flow: the mesh does not resolve it, or a"
            << " boundary condition follows the flow, which still changes"
            << endl;
    }
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
    systemFunction(name, runTime, dict, typeName),
    largestImbalance_(0),
    warned_(false)
{
    read(dict);

    writeHead
    (
        file(),
        string("Balance of mechanical energy") + unit(),
        List<const char*>
        {
            "dissipation", "kineticEnergyRate", "boundaries", "membranes",
            "drivingForce", "imbalance", "contact"
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::energyBalance::read(const dictionary& dict)
{
    warnOfOthers(dict, {"largestImbalance"});
    largestImbalance_ = capsule::input::getBetweenOrDefault<scalar>
    (
        dict,
        "largestImbalance",
        0.1,
        capsule::input::smallest,
        capsule::input::largest
    );
    return systemFunction::read(dict);
}


bool Foam::functionObjects::energyBalance::write()
{
    const capsule::membraneSystem& system = membranes();
    scalar rate = 0;
    bool known = true;
    if (postProcess)
    {
        takeWrittenBoundaries();
        known = capsule::kineticEnergyRate::read(mesh_, rate);
    }
    else
    {
        rate = capsule::kineticEnergyRate::ofStep
        (
            system.fluid().U(), system.fluid().density()
        );
    }

    const capsule::energyBudget budget(system, rate);
    writeRow(budget, known);
    if (known)
    {
        warnOfImbalance(budget);
    }
    else
    {
        warnOfUnknown();
    }
    return true;
}
