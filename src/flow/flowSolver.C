/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(flowSolver, 0);
    defineRunTimeSelectionTable(flowSolver, dictionary);

    //- Scalar product and length over all processors
    static scalar globalDot(const nodalScalars& a, const nodalScalars& b)
    {
        return returnReduce(scalar(a.dot(b)), sumOp<scalar>());
    }

    static scalar globalNorm(const nodalScalars& a)
    {
        return Foam::sqrt(globalDot(a, a));
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::flowSolver::addDirection
(
    const fvVectorMatrix& UEqn,
    const sources* extra,
    const nodalScalars& r,
    const nodalScalars& atRest,
    const scalar size
)
{
    vectorField momentum(mesh_.nCells());
    scalarField continuity(mesh_.nCells());
    vectorField dU(mesh_.nCells(), Zero);
    scalarField dp(mesh_.nCells(), Zero);
    unscale(r*(size/globalNorm(r)), momentum, continuity);
    apply(momentum, continuity, dU, dp);

    // The matrix times the unknowns, from the affine residual: their size is
    // that of the flow, so that little is lost in the difference
    searchDirection d;
    d.unknowns = packed(dU, dp);
    unpack(d.unknowns);
    d.residual = atRest - residual(UEqn, extra);

    for (const searchDirection& other : directions_)
    {
        const scalar share = globalDot(d.residual, other.residual);
        d.residual -= share*other.residual;
        d.unknowns -= share*other.unknowns;
    }
    const scalar length = globalNorm(d.residual) + VSMALL;
    d.residual /= length;
    d.unknowns /= length;

    if (label(directions_.size()) == maxDirections_)
    {
        directions_.pop_front();
    }
    directions_.push_back(std::move(d));
}


void Foam::capsule::flowSolver::converge
(
    const fvVectorMatrix& UEqn,
    const sources* extra,
    const nodalScalars& atRest,
    const nodalScalars* offset,
    const scalar reference,
    const char* what,
    nodalScalars& x
)
{
    const auto evaluate = [&]()
    {
        unpack(x);
        nodalScalars r = residual(UEqn, extra);
        if (offset)
        {
            r -= *offset;
        }
        return r;
    };
    nodalScalars r = evaluate();
    scalar norm = globalNorm(r);
    const scalar initial = norm;

    const auto advance = [&](const searchDirection& d)
    {
        const scalar step = globalDot(r, d.residual);
        x += step*d.unknowns;
        r -= step*d.residual;
    };
    for (const searchDirection& d : directions_)
    {
        advance(d);
    }

    label iter = 0;
    scalar last;
    do
    {
        while (globalNorm(r) > 0.9*tolerance_*reference && iter < maxIter_)
        {
            ++iter;
            addDirection(UEqn, extra, r, atRest, reference);
            advance(directions_.back());
        }

        // Round-off apart, the residual is that of the directions
        r = evaluate();
        last = norm;
        norm = globalNorm(r);
    }
    while
    (
        norm > tolerance_*reference && norm < 0.5*last && iter < maxIter_
    );

    applied(iter);

    Info<< type() << ":  Solving for " << what << ", Initial residual = "
        << initial/reference << ", Final residual = " << norm/reference
        << ", No Iterations " << iter << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::flowSolver::flowSolver
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const wordList& own
)
:
    flowEquations(dict, U, p, phi),
    tolerance_
    (
        input::getBetweenOrDefault<scalar>(dict, "tolerance", 1e-8, 1e-15, 0.1)
    ),
    maxIter_
    (
        input::getBetweenOrDefault<label>(dict, "maxIter", 100, 1, 10000)
    ),
    maxDirections_
    (
        input::getBetweenOrDefault<label>(dict, "directions", 60, 1, 10000)
    ),
    answersKnown_(false)
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
    surfaceScalarField& phi
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

    return autoPtr<flowSolver>(cstrIter()(dict, U, p, phi));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::flowSolver::begin(const fvVectorMatrix& UEqn)
{
    directions_.clear();
    answersKnown_ = false;
    set(UEqn);
    prepare(UEqn);
}


void Foam::capsule::flowSolver::solve
(
    const fvVectorMatrix& UEqn,
    const sources* extra
)
{
    nodalScalars x = packed(U_, p_);

    // Reference: what the fluid at rest leaves of the equations
    unpack(nodalScalars::Zero(x.size()));
    const nodalScalars atRest = residual(UEqn, extra);
    const scalar reference = globalNorm(atRest) + VSMALL;

    converge(UEqn, extra, atRest, nullptr, reference, "U, p", x);
}
