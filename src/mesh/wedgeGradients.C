/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "wedgeGradients.H"
#include "solvedDirections.H"
#include "wedgeFvPatch.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
    defineTypeNameAndDebug(wedgeGradients, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::wedgeGradients::wedgeGradients
(
    const fvMesh& mesh,
    const solvedDirections& directions
)
:
    MeshObject<fvMesh, GeometricMeshObject, wedgeGradients>(mesh)
{
    // OpenFOAM has them on demand, and gives them to all as constants
    auto& delta = const_cast<surfaceScalarField&>(mesh.deltaCoeffs());
    auto& orthogonal =
        const_cast<surfaceScalarField&>(mesh.nonOrthDeltaCoeffs());

    // Area of the faces of a cell away from the axis, as it is and as the
    // gradients see it
    scalarField area(mesh.nCells(), Zero);
    scalarField seen(mesh.nCells(), Zero);
    const auto add = [&](const label celli, const scalar S, const scalar factor)
    {
        area[celli] += S;
        seen[celli] += factor*S;
    };
    const auto radius = [&](const point& x)
    {
        return directions.radius(directions(x));
    };

    const pointField& centres = mesh.cellCentres();
    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        const label P = mesh.owner()[facei];
        const label N = mesh.neighbour()[facei];
        const scalar factor =
            2*radius(mesh.faceCentres()[facei])
           /(radius(centres[P]) + radius(centres[N]));
        delta[facei] *= factor;
        orthogonal[facei] *= factor;
        const scalar S = directions(mesh.faceAreas()[facei])(1);
        add(P, S, factor);
        add(N, -S, factor);
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        if (!solvedDirections::cutsPlane(patch.patch()))
        {
            continue;
        }
        const label patchi = patch.index();
        const vectorField across(patch.delta());
        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            scalar factor = 1;
            if (patch.coupled())
            {
                factor =
                    radius(patch.Cf()[i])
                   /radius(centres[celli] + 0.5*across[i]);
                delta.boundaryFieldRef()[patchi][i] *= factor;
                orthogonal.boundaryFieldRef()[patchi][i] *= factor;
            }
            add(celli, directions(patch.Sf()[i])(1), factor);
        }
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        if (isA<wedgeFvPatch>(patch))
        {
            forAll(patch, i)
            {
                const label celli = patch.faceCells()[i];
                const scalar factor = seen[celli]/area[celli];
                delta.boundaryFieldRef()[patch.index()][i] *= factor;
                orthogonal.boundaryFieldRef()[patch.index()][i] *= factor;
            }
        }
    }
}
