/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membrane.H"
#include "releases.H"
#include "fvMesh.H"
#include "passiveParticleCloud.H"
#include "IOField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Where a field of a cloud is written
static IOobject fieldOf(const passiveParticleCloud& cloud, const word& name)
{
    return IOobject
    (
        name,
        cloud.time().timeName(),
        cloud,
        IOobject::NO_READ,
        IOobject::NO_WRITE,
        false
    );
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::membrane::writeCloud(const fvMesh& mesh) const
{
    const closedSurface present(surface());
    nodalVectors wrapped(present.nodes().topRows(basis_->nCounted()));
    for (Eigen::Index i = 0; i < wrapped.rows(); ++i)
    {
        wrapped.row(i) = directions_.images().wrapped(present.nodes().row(i));
    }
    const pointField points(directions_.toPoints(wrapped));

    // Each point has one owner: the lowest processor that finds it
    auto owned = emptyCloud<passiveParticleCloud>(mesh, name());
    passiveParticleCloud& cloud = *owned;
    DynamicList<label> mine;
    forAll(points, i)
    {
        const label celli = mesh.findCell(points[i]);
        const label owner = returnReduce
        (
            celli == -1 ? Pstream::nProcs() : Pstream::myProcNo(),
            minOp<label>()
        );
        if (owner == Pstream::myProcNo())
        {
            cloud.addParticle(new passiveParticle(mesh, points[i], celli));
            mine.append(i);
        }
    }
    cloud.write();

    const auto writeVectors = [&](const word& name, const nodalVectors& v)
    {
        const vectorField all(directions_.toVectors(v));
        IOField<vector>(fieldOf(cloud, name), vectorField(all, mine)).write();
    };
    const auto writeScalars = [&](const word& name, const nodalScalars& v)
    {
        IOField<scalar> field(fieldOf(cloud, name), mine.size());
        forAll(mine, i)
        {
            field[i] = v(mine[i]);
        }
        field.write();
    };
    writeVectors("velocity", now().velocity);
    writeVectors("force", force(present, present.areaElement()));
    const membraneMechanics::principalValues p = principal(present);
    writeScalars("stretch", p.l1);
    writeScalars("tension", p.T1);
    if (directions_.axisymmetric())
    {
        writeScalars("hoopStretch", p.l2);
        writeScalars("hoopTension", p.T2);
    }
    else if (directions_.spatial())
    {
        writeScalars("secondStretch", p.l2);
        writeScalars("secondTension", p.T2);
    }
}
