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
    of a cell but for the known divergence of interpolation; level set near and everywhere; iterations and imbalance of the
    equivalent force; net force of the corrections.

    Exact: stream functions psi = (A r^m + B r^(m+2)) sin m theta inside and
    (C r^-m + E r^(2-m)) sin m theta outside.

Usage
    Test-immersedInterface viscosityRatio

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "flowSolver.H"
#include "immersedInterface.H"
#include "oneSidedFit.H"
#include "freeSpaceResponse.H"
#include "quasiNewton.H"
#include "linearResidual.H"

using namespace Foam;
using namespace Foam::capsule;

//- Exact solution of one mode, R = 1, viscosity 1 outside and lambda inside
struct modeFlow
{
    label m;
    scalar lambda;
    Eigen::Vector4d c;

    modeFlow
    (
        const label mode,
        const scalar ratio,
        const scalar fn,
        const scalar ft
    )
    :
        m(mode),
        lambda(ratio)
    {
        const scalar a = m;
        const scalar e[4] = {a, a + 2, -a, 2 - a};
        const scalar p[4] = {0, 4*(a + 1), 0, 4*(a - 1)};
        Eigen::Matrix4d M;
        for (label i = 0; i < 4; ++i)
        {
            // At r = 1: u_r = m, u_t = -e, du_r/dr = m (e - 1),
            // du_t/dr = -e (e - 1)
            const scalar side = (i < 2 ? -1 : 1);
            const scalar stress = (i < 2 ? -lambda : 1);
            M(0, i) = side*a;
            M(1, i) = -side*e[i];
            M(2, i) = stress*(-p[i] + 2*a*(e[i] - 1));
            M(3, i) = stress*(-e[i]*(e[i] - 1) + e[i] - a*a);
        }
        c = M.partialPivLu().solve(Eigen::Vector4d(0, 0, -fn, -ft));
    }

    void at(const vector2& x, vector2& u, scalar& p) const
    {
        at(x, x.norm() < 1, u, p);
    }

    //- The flow of one side, extended beyond it
    void at(const vector2& x, const bool in, vector2& u, scalar& p) const
    {
        const scalar r = x.norm();
        const scalar th = std::atan2(x(1), x(0));
        const scalar a = m;
        const scalar e0 = in ? a : -a;
        const scalar e1 = in ? a + 2 : 2 - a;
        const scalar c0 = in ? c(0) : c(2);
        const scalar c1 = in ? c(1) : c(3);
        const scalar psi = c0*std::pow(r, e0) + c1*std::pow(r, e1);
        const scalar dpsi =
            c0*e0*std::pow(r, e0 - 1) + c1*e1*std::pow(r, e1 - 1);
        const scalar ur = a*psi/r*std::cos(a*th);
        const scalar ut = -dpsi*std::sin(a*th);
        u << ur*std::cos(th) - ut*std::sin(th),
             ur*std::sin(th) + ut*std::cos(th);

        // Scaled pressure: over lambda inside
        p = (in ? 4*(a + 1)*std::pow(r, a) : 4*(a - 1)*std::pow(r, -a))*c1
           *std::cos(a*th);
    }
};


//- Residuals of the corrected operators on the exact fields of one viscosity,
//  with the exact jumps: laplacian and gradient in the cut cells and in the
//  others, flux over the face's area, all in the maximum norm
static void writeResiduals
(
    const modeFlow& exact,
    const vector2& centre,
    const solvedDirections& directions,
    const immersedInterface& interface,
    volVectorField U,
    volScalarField p
)
{
    const fvMesh& mesh = U.mesh();
    vector2 u;
    scalar q;
    forAll(U, celli)
    {
        exact.at(directions(mesh.C()[celli]) - centre, u, q);
        U[celli] = directions.toVector(u);
        p[celli] = q;
    }

    flowSolver::sources corrections(mesh);
    interface.addLaplacian(1, 1, corrections.momentum);
    interface.addGradient(corrections.gradient);
    interface.addFlux(corrections.flux, corrections.pressureFlux);
    const volVectorField laplacian(fvc::laplacian(U));
    const volVectorField gradient(fvc::grad(p));
    const surfaceScalarField flux(fvc::flux(U) + corrections.flux);

    scalar laplacians[2] = {0, 0};
    scalar gradients[2] = {0, 0};
    scalar fluxes = 0;
    const scalar step = 1e-4;
    forAll(U, celli)
    {
        // Away from the boundary, where the scheme is of lower order
        const vector2 x = directions(mesh.C()[celli]) - centre;
        if (x.cwiseAbs().maxCoeff() > 1.3)
        {
            continue;
        }

        // Exact gradient of the pressure = laplacian of the velocity
        const bool in = (x.norm() < 1);
        vector2 slope;
        for (label i = 0; i < 2; ++i)
        {
            vector2 ahead = x, behind = x;
            ahead(i) += step;
            behind(i) -= step;
            scalar plus, minus;
            exact.at(ahead, in, u, plus);
            exact.at(behind, in, u, minus);
            slope(i) = (plus - minus)/(2*step);
        }
        const label kind = (interface.cut().found(celli) ? 1 : 0);
        laplacians[kind] = max
        (
            laplacians[kind],
            (
                directions(laplacian[celli] + corrections.momentum[celli]) - slope
            ).norm()
        );
        gradients[kind] = max
        (
            gradients[kind],
            (
                directions(gradient[celli] + corrections.gradient[celli]) - slope
            ).norm()
        );
    }
    forAll(flux, facei)
    {
        // The face average: two Gauss points on each of many parts
        const face& f = mesh.faces()[facei];
        vector2 a = directions(mesh.points()[f[0]]);
        vector2 b = a;
        for (const label pointi : f)
        {
            const vector2 c = directions(mesh.points()[pointi]);
            b = (c - a).norm() > (b - a).norm() ? c : b;
        }
        vector mean(Zero);
        const label parts = 200;
        for (label i = 0; i < parts; ++i)
        {
            exact.at(a + (i + 0.5)/parts*(b - a) - centre, u, q);
            mean += directions.toVector(u)/parts;
        }
        const vector2 x = directions(mesh.faceCentres()[facei]) - centre;
        if (x.cwiseAbs().maxCoeff() < 1.3)
        {
            fluxes = max
            (
                fluxes,
                mag(flux[facei] - (mean & mesh.Sf()[facei]))
               /mesh.magSf()[facei]
            );
        }
    }
    Info<< "residuals " << laplacians[0] << ' ' << laplacians[1] << ' '
        << gradients[0] << ' ' << gradients[1] << ' ' << fluxes << endl;
}


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


//- Largest error of the velocity, and of the pressure the largest and the root
//  mean square
static void writeErrors
(
    const modeFlow& exact,
    const vector2& centre,
    const solvedDirections& directions,
    const volVectorField& U,
    const volScalarField& p
)
{
    const fvMesh& mesh = U.mesh();
    vector2 u;
    scalar q;
    scalarField dp(mesh.nCells());
    scalar maxU = 0;
    scalar outsideP = 0;
    scalar inside = 0;
    forAll(dp, celli)
    {
        exact.at(directions(mesh.C()[celli]) - centre, u, q);
        maxU = max(maxU, (directions(U[celli]) - u).cwiseAbs().maxCoeff());
        dp[celli] = p[celli] - q;
    }

    // The level of the real pressure is free: p/lambda inside
    forAll(dp, celli)
    {
        const bool in = ((directions(mesh.C()[celli]) - centre).norm() < 1);
        inside += in;
        outsideP += in ? 0 : dp[celli];
    }
    const scalar level = outsideP/(dp.size() - inside);
    forAll(dp, celli)
    {
        const bool in = ((directions(mesh.C()[celli]) - centre).norm() < 1);
        dp[celli] -= (in ? level/exact.lambda : level);
    }

    Info<< maxU << ' ' << max(mag(dp)) << ' '
        << Foam::sqrt(average(sqr(dp)));
}


//- Largest error of the level set near the circle, and of all
static void writeDistances
(
    const vector2& centre,
    const solvedDirections& directions,
    const immersedInterface& interface
)
{
    const volScalarField distance(interface.levelSet().whole());
    scalar nearD = 0;
    scalar maxD = 0;
    forAll(distance, celli)
    {
        const scalar r = (directions(distance.mesh().C()[celli]) - centre).norm();
        const scalar error = mag(distance[celli] - (r - 1));
        maxD = max(maxD, error);
        nearD = max(nearD, mag(r - 1) < 0.5 ? error : 0);
    }

    Info<< nearD << ' ' << maxD;
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

    const label mode = 3;
    const scalar lambda = args.get<scalar>(1);
    const modeFlow exact(mode, lambda, 1, 0.5);
    const vector2 centre(0.013, 0.027);
    const solvedDirections directions(mesh);

    setBoundaryValues(exact, centre, directions, U);

    const scalar h = Foam::sqrt(gMax(mesh.V().field())/directions.sector());
    const curveBasis basis(2*label(constant::mathematical::pi/h) + 1);
    nodalVectors x(basis.size(), 2);
    nodalVectors f(basis.size(), 2);
    for (label i = 0; i < basis.size(); ++i)
    {
        const scalar th = basis.alpha(i);
        const vector2 n(std::cos(th), std::sin(th));
        x.row(i) = centre + n;
        f.row(i) =
            std::cos(mode*th)*n
          + 0.5*std::sin(mode*th)*vector2(-n(1), n(0));
    }
    const closedSurface curve(basis, x);

    immersedInterface interface
    (
        "circle", mesh, directions, curve, oneSidedFit::radius
    );
    const dimensionedScalar mu("mu", dimPressure*dimTime, 1);
    const fvVectorMatrix UEqn(-fvm::laplacian(mu, U));
    autoPtr<flowSolver> flow
    (
        flowSolver::New(U, p, phi, dimensionedScalar(dimDensity, Zero))
    );
    flow->begin(UEqn);

    // Balance of real stress by the equivalent force, see membraneSystem
    const oneSidedFit fit(interface, -1);
    const label n = 2*basis.size();
    const nodalMatrix shortWaves = freeSpaceResponse::adjointDoubleLayer(curve);
    const nodalMatrix derivative =
        0.5*(1 + lambda)*nodalMatrix::Identity(n, n)
      - (1 - lambda)*shortWaves;
    linearResidual problem(derivative);
    couplingMethods::quasiNewton method{dictionary()};
    method.start();

    // The mesh takes the long waves of the force, see immersedMembrane
    const nodalFilter filter =
        basis.lowPass(curve.perimeter()/(constant::mathematical::twoPi*h));
    const nodalVectors& normal = curve.normal();
    const nodalVectors& tangent = curve.tangent();

    flowSolver::sources sources(mesh);
    nodalVectors equivalent = f;
    label iterations = 0;
    scalar imbalance = 1;
    scalar net = 0;
    while (imbalance > 1e-9 && iterations < 60)
    {
        const nodalVectors resolved =
            scaled(filter*dot(equivalent, normal), normal)
          + scaled(filter*dot(equivalent, tangent), tangent);
        const nodalVectors unresolved = equivalent - resolved;

        sources.clear();
        interface.setJumps
        (
            jumpConditions
            (
                curve,
                resolved,
                nodalVectors::Zero(basis.size(), 2),
                nodalScalars::Zero(basis.size()),
                1
            )
        );
        const vector sum =
            interface.addLaplacian(1, 1, sources.momentum)
          - interface.addGradient(sources.gradient);
        net = mag(sum)/directions.sector();
        interface.addFlux(sources.flux, sources.pressureFlux);
        interface.addInterpolationDivergence(sources.divergence);
        interface.addForce(-sum, sources.momentum);
        flow->solve(UEqn, &sources);

        const nodalScalars remote =
            shortWaves*Eigen::Map<const nodalScalars>(unresolved.data(), n);
        const nodalVectors left =
            f - equivalent
          + (1 - lambda)
           *(
                fit(U, &p).traction(normal, 1)
              + Eigen::Map<const nodalVectors>(remote.data(), n/2, 2)
              + 0.5*unresolved
            );
        problem.set(stacked(left));
        const nodalScalars x = method.next(stacked(equivalent), problem);
        equivalent = unstacked(x, 2);
        imbalance = problem.correction(problem.fluidResponse()).norm()/x.norm();
        ++iterations;
    }

    // At equal viscosities the equivalent force is the exact one
    if (lambda == 1)
    {
        writeResiduals(exact, centre, directions, interface, U, p);
    }

    Info<< "norms ";
    writeErrors(exact, centre, directions, U, p);
    Info<< ' '
        << gMax(mag((fvc::div(phi) - sources.divergence)().primitiveField()))
        << ' ';
    writeDistances(centre, directions, interface);
    Info<< ' ' << iterations << ' ' << imbalance << ' ' << net << endl;

    return 0;
}
