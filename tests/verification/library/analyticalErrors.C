/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "analyticalErrors.H"
#include "membraneSystem.H"
#include "volFields.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(analyticalErrors, 0);
    addToRunTimeSelectionTable(functionObject, analyticalErrors, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::functionObjects::analyticalErrors::axisCells() const
{
    DynamicList<label> cells;
    forAll(mesh_.cellPoints(), celli)
    {
        scalar nearest = GREAT;
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            nearest = min
            (
                nearest,
                directions_.radius(directions_(mesh_.points()[pointi]))
            );
        }
        const scalar r = directions_.radius(directions_(mesh_.C()[celli]));
        if (directions_.axisymmetric() && nearest < 1e-6*r)
        {
            cells.append(celli);
        }
    }
    return labelList(std::move(cells));
}


Foam::scalar Foam::functionObjects::analyticalErrors::interfaceError
(
    const scalar t
) const
{
    const auto* membranes =
        mesh_.findObject<capsule::membraneSystem>("membraneProperties");

    scalar largest = 0;
    for (label i = 0; membranes && i < membranes->nMembranes(); ++i)
    {
        const capsule::interfaceState& now = (*membranes)[i].now();
        for (label node = 0; node < now.x.rows(); ++node)
        {
            const capsule::solvedVector exact =
                exact_->velocity(now.x.row(node), t);
            const capsule::solvedVector found = now.velocity.row(node);
            largest = max(largest, (found - exact).norm());
        }
    }
    return largest;
}


Foam::boolList Foam::functionObjects::analyticalErrors::inside
(
    const scalar t
) const
{
    const auto* membranes =
        mesh_.findObject<capsule::membraneSystem>("membraneProperties");

    boolList result(mesh_.nCells(), false);
    if (!membranes || membranes->nMembranes() == 0)
    {
        forAll(result, celli)
        {
            result[celli] = exact_->inside(directions_(mesh_.C()[celli]), t);
        }
    }
    for (label i = 0; membranes && i < membranes->nMembranes(); ++i)
    {
        const capsule::membrane& m = (*membranes)[i];
        const capsule::closedSurface surface(m.basis(), m.now().interface);
        const capsule::membraneLevelSet distance
        (
            m.name(), mesh_, directions_, surface, 1
        );
        UIndirectList<bool>(result, distance.inside()) = true;
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::analyticalErrors::analyticalErrors
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, "errors", dict),
    exact_(capsule::analyticalSolution::New(mesh_)),
    directions_(mesh_),
    atAxis_(axisCells())
{
    writeCommented(file(), "Time");
    for (const char* column : {"U_L2", "U_max", "p_L2", "p_max", "interface"})
    {
        writeTabbed(file(), column);
    }
    if (directions_.axisymmetric())
    {
        writeTabbed(file(), "U_axis");
        writeTabbed(file(), "p_axis");
    }
    file() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::analyticalErrors::execute()
{
    return true;
}


bool Foam::functionObjects::analyticalErrors::write()
{
    const volVectorField& U = lookupObject<volVectorField>("U");
    const volScalarField& p = lookupObject<volScalarField>("p");
    const scalarField& V = mesh_.V().field();
    const scalar t = mesh_.time().value();

    scalarField dU(U.size());
    scalarField dp(p.size());
    scalarField outside(p.size());
    const boolList inside(this->inside(t));
    forAll(dU, celli)
    {
        const capsule::solvedVector x = directions_(mesh_.C()[celli]);
        dU[celli] = (directions_(U[celli]) - exact_->velocity(x, t)).norm();
        dp[celli] = p[celli] - exact_->pressure(x, t, inside[celli]);
        outside[celli] = inside[celli] ? 0 : V[celli];
    }
    dp -= gSum(outside*dp)/gSum(outside);

    const scalar volume = gSum(V);
    const scalar onInterface = interfaceError(t);
    file()
        << mesh_.time().timeOutputValue()
        << tab << Foam::sqrt(gSum(V*sqr(dU))/volume) << tab << gMax(dU)
        << tab << Foam::sqrt(gSum(V*sqr(dp))/volume) << tab << gMax(mag(dp))
        << tab << onInterface;
    if (directions_.axisymmetric())
    {
        file()
            << tab << gMax(scalarField(dU, atAxis_))
            << tab << gMax(mag(scalarField(dp, atAxis_)));
    }
    file() << endl;
    return true;
}
