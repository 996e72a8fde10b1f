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
#include "flowSolver.H"
#include "extrapolatedOutletFvPatchVectorField.H"
#include "fixedValueFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"
#include "IOdictionary.H"
#include "fvm.H"
#include "fvc.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{

//- A given force per volume
class givenForce
:
    public capsule::drivingForce
{
    const vector force_;

public:

    explicit givenForce(const vector& force)
    :
        force_(force)
    {}

    virtual vector force() const
    {
        return force_;
    }
};

} // End namespace functionObjects
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::functionObjects::extraPressureDrop::setDeveloped()
{
    volVectorField& U = *emptyU_;
    volScalarField& p = *emptyp_;
    const fvPatch& outlet = mesh_.boundary()[outlet_];
    const fvPatchVectorField& outflow = U.boundaryField()[outlet_];
    const bool follows =
        isA<extrapolatedOutletFvPatchVectorField>(outflow)
     || !outflow.fixesValue();
    if (!follows || p.boundaryField()[outlet_].fixesValue())
    {
        return false;
    }

    U.boundaryFieldRef().set
    (
        outlet_,
        new zeroGradientFvPatchVectorField(outlet, U)
    );
    p.boundaryFieldRef().set
    (
        outlet_,
        new fixedValueFvPatchScalarField(outlet, p)
    );
    p.boundaryFieldRef()[outlet_] == 0;
    return true;
}


void Foam::functionObjects::extraPressureDrop::solveEmpty()
{
    const auto& properties =
        mesh_.lookupObject<IOdictionary>("transportProperties");
    const dimensionedScalar mu("mu", dimPressure*dimTime, properties);
    mu_ = mu.value();

    emptyU_.reset
    (
        new volVectorField("emptyU", mesh_.lookupObject<volVectorField>("U"))
    );
    emptyp_.reset
    (
        new volScalarField("emptyp", mesh_.lookupObject<volScalarField>("p"))
    );
    volVectorField& U = *emptyU_;
    volScalarField& p = *emptyp_;

    // The result must not depend on the time: not on the present flow, and at
    // an outlet not on what follows it
    U.primitiveFieldRef() = Zero;
    p.primitiveFieldRef() = Zero;
    const bool developed = !driven() && setDeveloped();
    surfaceScalarField phi("emptyPhi", fvc::flux(U));

    Info<< type() << ' ' << name() << ": empty channel" << endl;
    autoPtr<capsule::flowSolver> flow
    (
        capsule::flowSolver::New
        (
            U, p, phi, dimensionedScalar(dimDensity, Zero)
        )
    );
    const fvVectorMatrix UEqn(-fvm::laplacian(mu, U));
    flow->begin(UEqn);
    if (driven())
    {
        givenForce driving(membranes().fluid().driving().force());
        flow->solve(UEqn, nullptr, driving);
        emptyDrop_ = driving.force() & period();
        flux_ = flux(U);
    }
    else
    {
        flow->solve(UEqn, nullptr);
        if (developed)
        {
            // As the pressure of the flow is taken there
            p.boundaryFieldRef()[outlet_] ==
                scalarField(p.boundaryField()[outlet_].patchInternalField());
        }
        emptyDrop_ = drop(p);
        flux_ = gSum(phi.boundaryField()[outlet_]);
    }
    checkFlux(gSum(mag(phi.primitiveField())));
}


void Foam::functionObjects::extraPressureDrop::checkFlux
(
    const scalar total
) const
{
    if (!(mag(flux_) > SMALL*total))
    {
        FatalIOErrorInFunction(mesh_.time().controlDict())
            << "The channel of the function object " << name() << " has no"
            << " flux: "
            << (
                   driven()
                 ? string("nothing drives it, see constant/drivingForce")
                 : "entry outlet is " + mesh_.boundary()[outlet_].name()
               ).c_str()
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
