/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sourceMoment.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vectorField Foam::capsule::sourceMoment::cutSource() const
{
    const labelUList& cells = interface_.cut();
    vectorField result(cells.size());
    forAll(cells, i)
    {
        result[i] = sources_.momentum[cells[i]] - sources_.gradient[cells[i]];
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sourceMoment::sourceMoment
(
    const sharpInterface& interface,
    const solvedDirections& directions,
    flowEquations::sources& sources
)
:
    interface_(interface),
    directions_(directions),
    sources_(sources),
    before_(cutSource())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::sourceMoment::correct
(
    const nodalVectors& f,
    const solvedVector& centre
)
{
    const closedSurface& surface = interface_.surface();
    const label m = surface.nRotations();
    const label d = surface.nComponents();
    const fvMesh& mesh = sources_.momentum.mesh();

    const labelUList& cells = interface_.cut();
    const vectorField source(cutSource() - before_);
    nodalVectors arm(cells.size(), d);
    nodalVectors force(cells.size(), d);
    nodalScalars volume(cells.size());
    forAll(cells, i)
    {
        const label celli = cells[i];
        volume(i) = mesh.V()[celli];
        arm.row(i) = interface_.levelSet().image(mesh.C()[celli]) - centre;
        force.row(i) = volume(i)*directions_(source[i]);
    }

    const auto sum = [](scalar value)
    {
        return returnReduce(value, sumOp<scalar>());
    };
    const scalar total = sum(volume.sum());
    if (total == 0)
    {
        return;
    }
    solvedVector middle(d);
    for (label j = 0; j < d; ++j)
    {
        middle(j) = sum(volume.dot(arm.col(j)))/total;
    }
    nodalScalars missing(m);
    nodalMatrix moments(m, m);
    for (label k = 0; k < m; ++k)
    {
        missing(k) =
            directions_.sector()*surface.moment(f, k)
          - sum(dot(turned(arm, k), force).sum());
        for (label l = 0; l < m; ++l)
        {
            const nodalVectors spin =
                turned(nodalVectors(arm.rowwise() - middle), l);
            moments(k, l) = sum(volume.dot(dot(turned(arm, k), spin)));
        }
    }
    const nodalScalars rates = moments.inverse()*missing;
    forAll(cells, i)
    {
        for (label k = 0; k < m; ++k)
        {
            const nodalVectors spin =
                turned(nodalVectors(arm.row(i) - middle), k);
            sources_.momentum[cells[i]] +=
                rates(k)*directions_.toVector(spin.row(0));
        }
    }
}


// ************************************************************************* //
