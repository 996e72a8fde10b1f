/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-immersedInterface

Description
    A force mode on a circle of radius 1 in Stokes flow,
    F = cos(3 theta) n + 0.5 sin(3 theta) t, viscosity 1 outside and
    viscosityRatio inside: level set, jumps, corrected operators, one-sided
    fits and the equivalent force against the exact solution. Writes one line of
    error norms: velocity max; scaled pressure max and L2; largest flux imbalance
    of a cell but for the known divergence of interpolation; level set near and
    everywhere; iterations and imbalance of the equivalent force; net force of
    the corrections.

    Exact: see modeFlow.

Usage
    Test-immersedInterface viscosityRatio

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "flowSolver.H"
#include "quasiNewton.H"
#include "errors.H"
#include "forcedFlow.H"
#include "linearResidual.H"

using namespace Foam;
using namespace Foam::capsule;

//- The exact velocity at the boundary, without the net flux of its samples
static void setBoundaryValues
(
    const modeFlow& exact,
    const vector2& centre,
    const solvedDirections& directions,
    volVectorField& U
)
{
    vector2 u;
    scalar q;
    forAll(U.boundaryField(), patchi)
    {
        fvPatchVectorField& Up = U.boundaryFieldRef()[patchi];
        forAll(Up, i)
        {
            exact.at(directions(Up.patch().Cf()[i]) - centre, u, q);
            Up[i] = directions.toVector(u);
        }
    }
    scalar flux = 0;
    scalar area = 0;
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        flux += gSum(Up & Up.patch().Sf());
        area += Up.size() ? gSum(Up.patch().magSf()) : 0;
    }
    forAll(U.boundaryField(), patchi)
    {
        fvPatchVectorField& Up = U.boundaryFieldRef()[patchi];
        Up == Up - flux/area*Up.patch().nf();
    }
}


//- How the iterations for the equivalent force have ended
struct balanced
{
    label iterations;
    scalar imbalance;
};


//- Balance of real stress by the equivalent force of a membrane's force f
static balanced balance
(
    forcedFlow& forced,
    const nodalVectors& f,
    const scalar lambda,
    const volVectorField& U,
    const volScalarField& p
)
{
    linearResidual problem(forced.derivative(lambda));
    couplingMethods::quasiNewton method{dictionary()};
    method.start();

    nodalVectors equivalent = f;
    balanced result{0, 1};
    while (result.imbalance > 1e-9 && result.iterations < 60)
    {
        forced.solve(equivalent);
        const nodalVectors left =
            f - equivalent
          + (1 - lambda)*forced.traction(U, p, equivalent);
        problem.set(stacked(left));
        const nodalScalars x = method.next(stacked(equivalent), problem);
        equivalent = unstacked(x, 2);
        result.imbalance =
            problem.correction(problem.fluidResponse()).norm()/x.norm();
        ++result.iterations;
    }
    return result;
}


//- The force mode on a circle, balanced; writes the errors
static void testMode
(
    const scalar lambda,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi
)
{
    const label mode = 3;
    const modeFlow exact(mode, lambda, 1, 0.5);
    const vector2 centre(0.013, 0.027);
    const solvedDirections directions(U.mesh());

    setBoundaryValues(exact, centre, directions, U);

    const scalar h = Foam::sqrt(gMax(U.mesh().V().field())/directions.sector());
    const forcedCircle circle
    (
        2*label(constant::mathematical::pi/h) + 1, centre, mode
    );
    immersedInterface interface
    (
        "circle",
        U.mesh(),
        directions,
        closedSurface(circle.basis, circle.x),
        oneSidedFit::radius
    );
    const dimensionedScalar mu("mu", dimPressure*dimTime, 1);
    const fvVectorMatrix UEqn(-fvm::laplacian(mu, U));
    autoPtr<flowSolver> flow
    (
        flowSolver::New(U, p, phi, dimensionedScalar(dimDensity, Zero))
    );
    flow->begin(UEqn);
    forcedFlow forced(*flow, UEqn, interface, h);
    const balanced found = balance(forced, circle.f, lambda, U, p);

    // At equal viscosities the equivalent force is the exact one
    if (lambda == 1)
    {
        writeResiduals(exact, centre, directions, interface, U, p);
    }

    Info<< "norms ";
    writeErrors(exact, centre, directions, U, p);
    Info<< ' '
        << gMax
        (
            mag((fvc::div(phi) - forced.sources().divergence)().primitiveField())
        )
        << ' ';
    writeDistances(centre, directions, interface);
    Info<< ' ' << found.iterations << ' ' << found.imbalance << ' '
        << forced.net() << endl;
}


int main(int argc, char *argv[])
{
    argList::addArgument("viscosityRatio");
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    volVectorField U
    (
        IOobject("U", runTime.timeName(), mesh, IOobject::MUST_READ), mesh
    );
    volScalarField p
    (
        IOobject("p", runTime.timeName(), mesh, IOobject::MUST_READ), mesh
    );
    #include "createPhi.H"

    testMode(args.get<scalar>(1), U, p, phi);

    return 0;
}
