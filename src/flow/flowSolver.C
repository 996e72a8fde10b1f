/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "flowSolver.H"
#include "fvc.H"
#include "findRefCell.H"
#include "surfaceInterpolate.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(flowSolver, 0);
    defineRunTimeSelectionTable(flowSolver, dictionary);

    //- Scalar product over all processors
    static scalar globalDot(const nodalScalars& a, const nodalScalars& b)
    {
        return returnReduce(scalar(a.dot(b)), sumOp<scalar>());
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::flowSolver::residual
(
    const fvVectorMatrix& UEqn,
    const sources* extra
)
{
    U_.correctBoundaryConditions();
    p_.correctBoundaryConditions();

    volVectorField gradp(fvc::grad(p_));
    vectorField momentum(-(UEqn & U_)().primitiveField());
    if (extra)
    {
        gradp += extra->gradient;
        gradp.correctBoundaryConditions();
        momentum += extra->momentum;
    }
    momentum -= gradp.primitiveField();

    phi_ =
        fvc::flux(U_)
      + rAUf_
       *(
            (fvc::interpolate(gradp) & mesh_.Sf())
          - fvc::snGrad(p_)*mesh_.magSf()
        );
    if (extra)
    {
        phi_ += extra->flux + rAUf_*extra->pressureFlux;
    }

    // Boundary fluxes are those of the velocity; where the pressure is fixed,
    // the gradient of the cell against that of the face
    forAll(phi_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        if (pp.coupled())
        {
            continue;
        }
        const vectorField& S = mesh_.Sf().boundaryField()[patchi];
        scalarField flux(U_.boundaryField()[patchi] & S);
        if (pp.fixesValue())
        {
            flux +=
                rAUf_.boundaryField()[patchi]
               *(
                    (gradp.boundaryField()[patchi].patchInternalField() & S)
                  - pp.snGrad()*mesh_.magSf().boundaryField()[patchi]
                );
        }
        phi_.boundaryFieldRef()[patchi] = flux;
    }

    scalarField continuity(-fvc::div(phi_)().primitiveField());
    if (pRefCell_ != -1)
    {
        // The last equation left over by those of the other cells
        continuity[pRefCell_] = 
            (pRefValue_ - p_[pRefCell_])/pressureScale_;
    }

    const label n = mesh_.nCells();
    nodalScalars r(3*n);
    for (label celli = 0; celli < n; ++celli)
    {
        r.segment<2>(3*celli) =
            momentumScale_[celli]*plane_(momentum[celli]).transpose();
        r(3*celli + 2) = continuityScale_[celli]*continuity[celli];
    }
    return r;
}


Foam::capsule::nodalScalars Foam::capsule::flowSolver::packed() const
{
    nodalScalars x(3*mesh_.nCells());
    forAll(U_, celli)
    {
        x.segment<2>(3*celli) = plane_(U_[celli]).transpose();
        x(3*celli + 2) = p_[celli];
    }
    return x;
}


void Foam::capsule::flowSolver::unpack(const nodalScalars& x)
{
    forAll(U_, celli)
    {
        U_[celli] = plane_.toVector(x.segment<2>(3*celli));
        p_[celli] = x(3*celli + 2);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::flowSolver::sources::sources(const fvMesh& mesh)
:
    momentum
    (
        IOobject("interfaceMomentum", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimPressure/dimLength, Zero)
    ),
    gradient
    (
        IOobject("interfaceGradient", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimPressure/dimLength, Zero)
    ),
    flux
    (
        IOobject("interfaceFlux", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimVelocity*dimArea, Zero)
    ),
    pressureFlux
    (
        IOobject("interfacePressureFlux", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimPressure*dimLength, Zero)
    )
{
    flux.setOriented();
    pressureFlux.setOriented();
}


void Foam::capsule::flowSolver::sources::clear()
{
    momentum = dimensionedVector(momentum.dimensions(), Zero);
    gradient = dimensionedVector(gradient.dimensions(), Zero);
    flux = dimensionedScalar(flux.dimensions(), Zero);
    pressureFlux = dimensionedScalar(pressureFlux.dimensions(), Zero);
}


Foam::capsule::flowSolver::flowSolver
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi
)
:
    tolerance_
    (
        dict.getCheckOrDefault<scalar>
        (
            "tolerance", 1e-8, scalarMinMax(VSMALL, 0.1)
        )
    ),
    maxIter_(dict.getCheckOrDefault<label>("maxIter", 60, labelMinMax::ge(1))),
    mesh_(U.mesh()),
    plane_(mesh_),
    U_(U),
    p_(p),
    phi_(phi),
    pRefCell_(-1),
    pRefValue_(0),
    rAUf_
    (
        IOobject("rAUf", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimVelocity*dimLength/dimPressure, Zero)
    )
{
    if (p.needReference())
    {
        label cell = 0;
        setRefCell
        (
            mesh_.lookupObject<volScalarField>("p"), p, dict, cell, pRefValue_
        );
        pRefCell_ = cell;
    }
}


Foam::autoPtr<Foam::capsule::flowSolver> Foam::capsule::flowSolver::New
(
    const dictionary& dict,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi
)
{
    const word type(dict.get<word>("solver"));

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
    const volScalarField rAU(1.0/UEqn.A());
    rAUf_ = fvc::interpolate(rAU);

    // Both residuals as velocities: h^2/mu times force, h times divergence
    momentumScale_ = rAU.primitiveField();
    continuityScale_.setSize(mesh_.nCells());
    forAll(continuityScale_, celli)
    {
        continuityScale_[celli] =
            Foam::sqrt(mesh_.V()[celli]/plane_.thickness());
    }

    // Pressure over divergence: the reference equation in the same units
    pressureScale_ = gMax(sqr(continuityScale_)/momentumScale_);

    prepare(UEqn);
}


void Foam::capsule::flowSolver::solve
(
    const fvVectorMatrix& UEqn,
    const sources* extra
)
{
    // Reference: what the fluid at rest leaves of the equations
    const nodalScalars start = packed();
    unpack(nodalScalars::Zero(start.size()));
    const nodalScalars atRest = residual(UEqn, extra);
    const scalar reference = Foam::sqrt(globalDot(atRest, atRest)) + VSMALL;

    unpack(start);
    nodalScalars x = start;
    nodalScalars r = residual(UEqn, extra);
    scalar norm = Foam::sqrt(globalDot(r, r));
    const scalar initial = norm;

    const auto preconditioned = [&](const nodalScalars& v)
    {
        vectorField momentum(mesh_.nCells());
        scalarField continuity(mesh_.nCells());
        vectorField dU(mesh_.nCells(), Zero);
        scalarField dp(mesh_.nCells(), Zero);
        forAll(momentum, celli)
        {
            momentum[celli] =
                plane_.toVector(v.segment<2>(3*celli))/momentumScale_[celli];
            continuity[celli] = v(3*celli + 2)/continuityScale_[celli];
        }
        apply(UEqn, momentum, continuity, dU, dp);

        nodalScalars z(v.size());
        forAll(momentum, celli)
        {
            z.segment<2>(3*celli) = plane_(dU[celli]).transpose();
            z(3*celli + 2) = dp[celli];
        }
        return z;
    };

    label iter = 0;
    while (norm > tolerance_*reference && iter < maxIter_)
    {
        // One cycle of flexible GMRES from the present residual
        const label restart = min(label(40), maxIter_ - iter);
        std::vector<nodalScalars> v(1, r/norm);
        std::vector<nodalScalars> z;
        nodalMatrix h = nodalMatrix::Zero(restart + 1, restart);
        nodalScalars y;

        for (label k = 0; k < restart; ++k)
        {
            z.push_back(preconditioned(v[k]));
            ++iter;

            // Product with the matrix, from the affine residual
            unpack(reference*z[k]);
            nodalScalars w = (atRest - residual(UEqn, extra))/reference;
            for (label j = 0; j <= k; ++j)
            {
                h(j, k) = globalDot(w, v[j]);
                w -= h(j, k)*v[j];
            }
            h(k + 1, k) = Foam::sqrt(globalDot(w, w));
            v.push_back(w/(h(k + 1, k) + VSMALL));

            nodalScalars e = nodalScalars::Zero(k + 2);
            e(0) = norm;
            const nodalMatrix hk = h.topLeftCorner(k + 2, k + 1);
            y = hk.colPivHouseholderQr().solve(e);
            if ((e - hk*y).norm() < 0.5*tolerance_*reference)
            {
                break;
            }
        }

        for (label j = 0; j < y.size(); ++j)
        {
            x += y(j)*z[j];
        }
        unpack(x);
        r = residual(UEqn, extra);
        const scalar last = norm;
        norm = Foam::sqrt(globalDot(r, r));
        if (norm > 0.9*last)
        {
            break;
        }
    }

    applied(iter);

    Info<< type() << ":  Solving for U, p, Initial residual = "
        << initial/reference << ", Final residual = " << norm/reference
        << ", No Iterations " << iter << endl;
}
