/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "wallStress.H"
#include "membraneSystem.H"
#include "input.H"
#include "volFields.H"
#include "wallPolyPatch.H"
#include "wordRes.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(wallStress, 0);
    addToRunTimeSelectionTable(functionObject, wallStress, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::wallStress::wallStress
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    systemFunction(name, runTime, dict, typeName)
{
    read(dict);

    writeHead
    (
        file(),
        "Shear stress [Pa], and force per thickness [N/m],"
        " in a wedge of the whole turn [N], along the axis only, in space [N]",
        List<const char*>
        {
            "patch", "minShear", "maxShear",
            "pressureX", "pressureY", "pressureZ",
            "viscousX", "viscousY", "viscousZ"
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::wallStress::read(const dictionary& dict)
{
    warnOfOthers(dict, {"patches"});

    const polyBoundaryMesh& boundary = mesh_.boundaryMesh();
    DynamicList<label> found;
    if (dict.found("patches"))
    {
        const wordRes names(capsule::input::get<wordRes>(dict, "patches"));
        forAll(boundary, patchi)
        {
            const polyPatch& pp = boundary[patchi];
            if
            (
                names.match(pp.name())
             && !pp.coupled() && capsule::solvedDirections::cutsPlane(pp)
            )
            {
                found.append(patchi);
            }
        }
        if (found.empty())
        {
            FatalIOErrorInFunction(dict)
                << "Entry patches " << flatOutput(names) << " names no patch"
                << " that bounds the flow; permitted: of "
                << flatOutput(boundary.names()) << " those that are neither"
                << " empty nor coupled" << exit(FatalIOError);
        }
    }
    else
    {
        forAll(boundary, patchi)
        {
            if (isA<wallPolyPatch>(boundary[patchi]))
            {
                found.append(patchi);
            }
        }
    }
    patches_ = found;

    return systemFunction::read(dict);
}


bool Foam::functionObjects::wallStress::write()
{
    const capsule::membraneSystem& system = membranes();
    const auto& p = mesh_.lookupObject<volScalarField>("p");
    const scalar sector = system.directions().sector();
    const volTensorField gradient(system.fluid().velocityGradient());
    const volScalarField viscosity(system.fluid().viscosity());

    volVectorField shear
    (
        IOobject(typeName, mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimPressure, Zero)
    );

    for (const label patchi : patches_)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const vectorField normal(patch.nf());
        const vectorField traction
        (
           -2*viscosity.boundaryField()[patchi]
           *symm(gradient.boundaryField()[patchi])
          & normal
        );
        fvPatchVectorField& stress = shear.boundaryFieldRef()[patchi];
        stress == traction - normal*(normal & traction);

        const scalarField size(mag(stress));
        const scalar least = gMin(size);
        const scalar largest = gMax(size);
        const vector pressure
        (
            gSum(p.boundaryField()[patchi]*patch.Sf())/sector
        );
        const vector viscous(gSum(traction*patch.magSf())/sector);

        if (Pstream::master())
        {
            file()
                << mesh_.time().timeOutputValue() << tab << patch.name()
                << tab << least << tab << largest;
            for (const vector& force : {pressure, viscous})
            {
                for (const scalar component : force)
                {
                    file() << tab << component;
                }
            }
            file() << endl;
        }
    }
    if (postProcess || mesh_.time().writeTime())
    {
        // Not a time of its own, which nothing could go on from
        shear.write();
    }
    return true;
}
