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

Foam::scalar Foam::capsule::membraneLevelSet::sampleAlpha
(
    const label sample
) const
{
    return sample*constant::mathematical::twoPi/samples_.size();
}


Foam::scalar Foam::capsule::membraneLevelSet::project
(
    const vector2& x,
    scalar& alpha
) const
{
    alpha = curve_.nearest(x, alpha);
    // x' turned points out: its side is the sign of the distance
    vector2 foot, x1, x2;
    curve_.expand(alpha, foot, x1, x2);
    const vector2 d = x - foot;
    return d.dot(turned(x1)) < 0 ? -d.norm() : d.norm();
}


Foam::tmp<Foam::volScalarField>
Foam::capsule::membraneLevelSet::newField(const scalar outside) const
{
    tmp<volScalarField> tfield
    (
        volScalarField::New
        (
            "levelSet." + name_,
            mesh_,
            dimensionedScalar("outside", dimLength, outside)
        )
    );
    UIndirectList<scalar>(tfield.ref(), inside_) = -outside;
    return tfield;
}


void Foam::capsule::membraneLevelSet::setCells
(
    const UList<label>& candidates,
    const nodalVectors& normals,
    const scalar reach
)
{
    const pointField& centres = cellSearch::New(mesh_).centres();
    DynamicList<scalar> alphas;
    DynamicList<scalar> distances;

    for (const label celli : candidates)
    {
        const vector2 x = image(centres[celli]);
        const point c = plane_.toPoint(x);
        pointIndexHit hit = tree_->findNearest(c, sqr(reach));
        scalar distance;
        if (hit.hit())
        {
            scalar alpha = sampleAlpha(hit.index());
            distance = project(x, alpha);
            cells_.append(celli);
            alphas.append(alpha);
            distances.append(distance);
        }
        else
        {
            // Far off, the nearest sample tells the side
            hit = tree_->findNearest(c, sqr(GREAT));
            distance =
                (x - plane_(hit.hitPoint())).dot(normals.row(hit.index()));
        }
        if (distance < 0)
        {
            inside_.append(celli);
        }
    }

    alpha_ = Eigen::Map<const nodalScalars>(alphas.cdata(), alphas.size());
    distance_ =
        Eigen::Map<const nodalScalars>(distances.cdata(), distances.size());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneLevelSet::membraneLevelSet
(
    const word& name,
    const fvMesh& mesh,
    const solvedDirections& plane,
    const closedSurface& curve,
    const scalar bandWidth
)
:
    name_(name),
    mesh_(mesh),
    plane_(plane),
    curve_(curve),
    samples_(plane.toPoints(curve.sampled(4*curve.size()))),
    width_(0),
    band_(0),
    centre_(plane(boundBox(samples_, false).midpoint()))
{
    // Geometry that the processors make together: not later, on those alone
    // that hold a part of the membrane
    mesh.C();
    mesh.nonOrthDeltaCoeffs();

    treeBoundBox bounds(samples_);
    bounds.min() -= vector::uniform(0.1*curve.perimeter());
    bounds.max() += vector::uniform(0.1*curve.perimeter());
    tree_.reset
    (
        new indexedOctree<treeDataPoint>
        (
            treeDataPoint(samples_), bounds, 8, 10, 3
        )
    );

    const cellSearch& search = cellSearch::New(mesh);
    const pointField& centres = search.centres();

    // Cell width: the largest of the cells that the curve runs through
    const scalar sampleSpacing = 2*curve.perimeter()/samples_.size();
    const List<vector2> images
    (
        plane.images().images(centre_, plane.images().wrapped(centre_))
    );
    const auto boxAround = [&](const scalar margin, const vector2& image)
    {
        const vector shift(plane.toVector(image - centre_));
        boundBox box(samples_, false);
        box.min() += shift - vector::uniform(margin);
        box.max() += shift + vector::uniform(margin);
        return box;
    };
    const auto around = [&](const scalar margin)
    {
        DynamicList<label> cells;
        for (const vector2& i : images)
        {
            cells.append(search.inBox(boxAround(margin, i)));
        }
        Foam::inplaceUniqueSort(cells);
        return cells;
    };
    const auto findObstacles = [&](const scalar margin)
    {
        obstacles_.clear();
        for (const vector2& i : images)
        {
            lineOfSight::New(mesh).append
            (
                boxAround(margin, i), centre_ - i, obstacles_
            );
        }
    };

    findObstacles(search.largestWidth() + sampleSpacing);
    for (const label celli : around(search.largestWidth() + sampleSpacing))
    {
        const scalar h = search.ofCell(celli).largest();
        const vector2 x = image(centres[celli]);
        const pointIndexHit hit =
            tree_->findNearest(plane.toPoint(x), sqr(h + sampleSpacing));
        if (hit.hit() && sees(plane(hit.hitPoint()), x))
        {
            width_ = max(width_, h);
        }
    }
    reduce(width_, maxOp<scalar>());

    band_ = bandWidth*width_;
    const scalar reach = band_ + sampleSpacing;
    findObstacles(reach);

    nodalVectors normals(samples_.size(), 2);
    for (label i = 0; i < samples_.size(); ++i)
    {
        normals.row(i) =
            turned(curve.point(sampleAlpha(i), 1));
    }
    setCells(around(reach), normals, reach);
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
    for (const vector2& image : plane_.images().images(x, centre_))
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

    alpha = sampleAlpha(sample);
    return project(nearest, alpha);
}


Foam::scalar Foam::capsule::membraneLevelSet::signedDistanceFrom
(
    const vector2& x,
    scalar& alpha
) const
{
    return project(plane_.images().image(x, centre_), alpha);
}


Foam::tmp<Foam::volScalarField> Foam::capsule::membraneLevelSet::near() const
{
    tmp<volScalarField> tfield(newField(band_));
    volScalarField& field = tfield.ref();

    forAll(cells_, i)
    {
        field[cells_[i]] = max(-band_, min(band_, distance_(i)));
    }
    forAll(field.boundaryField(), patchi)
    {
        fvPatchScalarField& pf = field.boundaryFieldRef()[patchi];
        const vectorField& faces = mesh_.C().boundaryField()[patchi];
        pf = pf.patchInternalField();
        forAll(pf, i)
        {
            if (mag(pf[i]) < band_)
            {
                scalar alpha;
                const scalar d = signedDistance(plane_(faces[i]), alpha);
                pf[i] = max(-band_, min(band_, d));
            }
        }
    }

    return tfield;
}


Foam::tmp<Foam::volScalarField> Foam::capsule::membraneLevelSet::whole() const
{
    tmp<volScalarField> tfield(newField(1));
    volScalarField& field = tfield.ref();

    forAll(field, celli)
    {
        scalar alpha;
        field[celli] *= mag(signedDistance(plane_(mesh_.C()[celli]), alpha));
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
