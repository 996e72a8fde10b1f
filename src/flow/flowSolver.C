/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"
#include "familyEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(flowSolver, 0);
    defineRunTimeSelectionTable(flowSolver, dictionary);
}
}

const Foam::scalar Foam::capsule::flowSolver::roundOff = 100*SMALL;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Stop at entries other than those of all solvers and of the pressure's level
static void permit(const dictionary& dict)
{
    familyEntries<flowSolver>::permit
    (
        dict, {"solver", "pRefCell", "pRefPoint", "pRefValue"}
    );
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::flowSolver::flowSolver
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const dimensionedScalar& rho
)
:
    flowEquations(dict, U, p, phi),
    rho_(rho),
    atStart_(dict),
    digest_(dict.digest())
{
    permit(dict);
}


Foam::autoPtr<Foam::capsule::flowSolver> Foam::capsule::flowSolver::New
(
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const dimensionedScalar& rho
)
{
    const dictionary& dict = input::subDict
    (
        input::subDict(U.mesh().solutionDict(), "capsuleFoam"),
        "flow"
    );
    const auto& table = *dictionaryConstructorTablePtr_;
    const word type(input::choice(dict, "solver", table.sortedToc()));
    Info<< "Flow solver: " << type << endl;

    return autoPtr<flowSolver>(table[type](dict, U, p, phi, rho));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::flowSolver::readIfModified()
{
    const dictionary* ours = mesh_.solutionDict().findDict("capsuleFoam");
    const dictionary* dict = ours ? ours->findDict("flow") : nullptr;
    const SHA1Digest digest(dict ? dict->digest() : SHA1Digest());
    if (digest == digest_)
    {
        return;
    }
    digest_ = digest;

    const bool throwing = FatalIOError.throwExceptions();
    try
    {
        const dictionary& flow = input::subDict
        (
            input::subDict(mesh_.solutionDict(), "capsuleFoam"),
            "flow"
        );
        permit(flow);
        for (const char* e : {"solver", "pRefCell", "pRefPoint", "pRefValue"})
        {
            const entry* now = flow.findEntry(e);
            const entry* then = atStart_.findEntry(e);
            if (bool(now) != bool(then) || (now && *now != *then))
            {
                IOWarningInFunction(flow)
                    << "Entry " << e << " is read at the start of a run only:"
                    << " its change counts after a restart" << endl;
            }
        }
        readOwn(flow);
        Info<< "Flow solver: its entries in fvSolution have been read again"
            << endl;
    }
    catch (const Foam::IOerror& wrong)
    {
        WarningInFunction
            << "Entries of " << mesh_.solutionDict().name()
            << "/capsuleFoam/flow are wrong; the run goes on with those it"
            << " had: " << wrong.message().c_str() << endl;
    }
    FatalIOError.throwExceptions(throwing);
}
