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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- The coefficients, and what they make of the cells
struct wedgeCoefficients
{
    const fvMesh& mesh;
    const solvedDirections& directions;

    //- OpenFOAM has them on demand, and gives them to all as constants
    surfaceScalarField& delta;
    surfaceScalarField& orthogonal;

    //- Area of the faces of a cell away from the axis, as it is and as the
    //  gradients see it
    scalarField area;
    scalarField seen;


    wedgeCoefficients(const fvMesh& wedge, const solvedDirections& solved)
    :
        mesh(wedge),
        directions(solved),
        delta(const_cast<surfaceScalarField&>(mesh.deltaCoeffs())),
        orthogonal(const_cast<surfaceScalarField&>(mesh.nonOrthDeltaCoeffs())),
        area(mesh.nCells(), Zero),
        seen(mesh.nCells(), Zero)
    {}

    scalar radius(const point& x) const
    {
        return directions.radius(directions(x));
    }

    void add(const label celli, const scalar S, const scalar factor)
    {
        area[celli] += S;
        seen[celli] += factor*S;
    }

    void multiply(const fvPatch& patch, const label i, const scalar factor)
    {
        delta.boundaryFieldRef()[patch.index()][i] *= factor;
        orthogonal.boundaryFieldRef()[patch.index()][i] *= factor;
    }

    void setInternal()
    {
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
    }

    //- A patch across the plane of the wedge
    void setAcross(const fvPatch& patch)
    {
        const pointField& centres = mesh.cellCentres();
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
                multiply(patch, i, factor);
            }
            add(celli, directions(patch.Sf()[i])(1), factor);
        }
    }

    //- A side of the wedge, once all others are set
    void setSide(const fvPatch& patch)
    {
        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            multiply(patch, i, seen[celli]/area[celli]);
        }
    }
};

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::wedgeGradients::wedgeGradients
(
    const fvMesh& mesh,
    const solvedDirections& directions
)
:
    MeshObject<fvMesh, GeometricMeshObject, wedgeGradients>(mesh)
{
    wedgeCoefficients coefficients(mesh, directions);

    coefficients.setInternal();
    for (const fvPatch& patch : mesh.boundary())
    {
        if (solvedDirections::cutsPlane(patch.patch()))
        {
            coefficients.setAcross(patch);
        }
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        if (isA<wedgeFvPatch>(patch))
        {
            coefficients.setSide(patch);
        }
    }
}
