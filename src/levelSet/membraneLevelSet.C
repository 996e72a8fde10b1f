/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneLevelSet.H"
#include "mathematicalConstants.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::membraneLevelSet::project
(
    const vector2& x,
    const label sample,
    scalar& alpha,
    scalar& distance
) const
{
    const scalar first =
        sample*constant::mathematical::twoPi/samples_.size();

    alpha = curve_.nearest(x, first);

    // x' turned points out: its side is the sign of the distance
    const vector2 d = x - curve_.point(alpha);
    distance = d.norm();
    if (d.dot(turned(curve_.point(alpha, 1))) < 0)
    {
        distance = -distance;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneLevelSet::membraneLevelSet
(
    const word& name,
    const fvMesh& mesh,
    const meshPlane& plane,
    const closedCurve& curve,
    const scalar bandWidth
)
:
    name_(name),
    mesh_(mesh),
    plane_(plane),
    curve_(curve),
    samples_(plane.toPoints(curve.sampled(4*curve.size()))),
    width_(0),
    centre_(plane(boundBox(samples_, false).midpoint())),
    side_
    (
        IOobject
        (
            "side:" + name,
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar("one", dimless, 1)
    )
{
    // Geometry that the processors make together: not later, on those alone
    // that hold a part of the membrane
    mesh.C();
    mesh.nonOrthDeltaCoeffs();

    const nodalVectors corners = curve.sampled(samples_.size());
    treeBoundBox bounds(samples_);
    bounds.min() -= vector::uniform(plane.thickness());
    bounds.max() += vector::uniform(plane.thickness());
    tree_.reset
    (
        new indexedOctree<treeDataPoint>
        (
            treeDataPoint(samples_), bounds, 8, 10, 3
        )
    );

    const vectorField& centres = mesh.cellCentres();
    const scalarField& volumes = mesh.cellVolumes();

    // Cell width: the largest of the cells that the curve runs through
    const scalar sampleSpacing = 2*curve.perimeter()/samples_.size();
    const scalar crossing =
        sqr(Foam::sqrt(gMax(volumes)/plane.thickness()) + sampleSpacing);
    boundBox box(samples_, false);
    box.min() -= vector::uniform(Foam::sqrt(crossing));
    box.max() += vector::uniform(Foam::sqrt(crossing));

    const auto middle = [&](const label celli)
    {
        return plane.toPoint(image(centres[celli]));
    };

    forAll(centres, celli)
    {
        const point c = middle(celli);
        if (box.contains(c))
        {
            const scalar h = Foam::sqrt(volumes[celli]/plane.thickness());
            if (tree_->findNearest(c, sqr(h + sampleSpacing)).hit())
            {
                width_ = max(width_, h);
            }
        }
    }
    reduce(width_, maxOp<scalar>());

    const scalar band = bandWidth*width_;
    const scalar reach = sqr(band + sampleSpacing);
    box = boundBox(samples_, false);
    box.min() -= vector::uniform(Foam::sqrt(reach));
    box.max() += vector::uniform(Foam::sqrt(reach));

    DynamicList<scalar> alphas;
    DynamicList<scalar> distances;

    forAll(centres, celli)
    {
        const point c = middle(celli);
        if (!box.contains(c))
        {
            continue;
        }

        const pointIndexHit hit = tree_->findNearest(c, reach);
        if (hit.hit())
        {
            scalar alpha, distance;
            project(plane(c), hit.index(), alpha, distance);
            side_[celli] = (distance < 0 ? -1 : 1);
            cells_.append(celli);
            alphas.append(alpha);
            distances.append(distance);
        }
        else if (inPolygon(plane(c), corners))
        {
            side_[celli] = -1;
        }
    }
    side_.correctBoundaryConditions();

    alpha_ = Eigen::Map<const nodalScalars>(alphas.cdata(), alphas.size());
    distance_ =
        Eigen::Map<const nodalScalars>(distances.cdata(), distances.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::membraneLevelSet::signedDistance
(
    const vector2& x,
    scalar& alpha
) const
{
    vector2 nearest = x;
    label sample = -1;
    scalar bound = sqr(GREAT);
    for (const vector2& image : plane_.images(x, centre_))
    {
        const point c = plane_.toPoint(image);
        const pointIndexHit hit = tree_->findNearest(c, bound);
        if (hit.hit())
        {
            nearest = image;
            sample = hit.index();
            bound = magSqr(hit.hitPoint() - c);
        }
    }

    scalar distance;
    project(nearest, sample, alpha, distance);
    return distance;
}


Foam::tmp<Foam::volScalarField> Foam::capsule::membraneLevelSet::field() const
{
    tmp<volScalarField> tfield
    (
        volScalarField::New
        (
            "levelSet." + name_,
            mesh_,
            dimensionedScalar(dimLength, Zero)
        )
    );
    volScalarField& field = tfield.ref();

    forAll(field, celli)
    {
        scalar alpha;
        field[celli] =
            side_[celli]
           *mag(signedDistance(plane_(mesh_.C()[celli]), alpha));
    }
    forAll(field.boundaryField(), patchi)
    {
        fvPatchScalarField& pf = field.boundaryFieldRef()[patchi];
        const vectorField& faces = mesh_.C().boundaryField()[patchi];
        forAll(pf, i)
        {
            scalar alpha;
            pf[i] = signedDistance(plane_(faces[i]), alpha);
        }
    }

    return tfield;
}
