/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"
#include "input.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(flowSolver, 0);
    defineRunTimeSelectionTable(flowSolver, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::flowSolver::flowSolver
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const dimensionedScalar& rho,
    const wordList& own
)
:
    flowEquations(dict, U, p, phi),
    rho_(rho)
{
    input::permit
    (
        dict,
        input::joined
        (
            {
                "solver",
                "tolerance",
                "maxIter",
                "directions",
                "refactor",
                "nCorrectors",
                "nNonOrthogonalCorrectors",
                "momentumPredictor",
                "pRefCell",
                "pRefPoint",
                "pRefValue"
            },
            own
        )
    );
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
    const word type(input::get<word>(dict, "solver"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "flow solver",
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    Info<< "Flow solver: " << type << endl;

    return autoPtr<flowSolver>(cstrIter()(dict, U, p, phi, rho));
}
