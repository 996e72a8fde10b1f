/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneLevelSet.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
    DynamicList<scalar> distances;

    for (const label celli : candidates)
    {
        const solvedVector x = image(centres[celli]);
        const point c = directions_.toPoint(x);
        pointIndexHit hit = tree_->findNearest(c, sqr(reach));
        scalar distance;
        if (hit.hit())
        {
            surfaceParameter foot = parameters_[hit.index()];
            distance = surface_.signedDistance(x, foot);
            cells_.append(celli);
            feet_.append(foot);
            distances.append(distance);
        }
        else
        {
            // Far off, the nearest sample tells the side
            hit = tree_->findNearest(c, sqr(GREAT));
            distance =
                (x - directions_(hit.hitPoint())).dot(normals.row(hit.index()));
        }
        if (distance < 0)
        {
            inside_.append(celli);
        }
    }

    distance_ =
        Eigen::Map<const nodalScalars>(distances.cdata(), distances.size());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneLevelSet::membraneLevelSet
(
    const word& name,
    const fvMesh& mesh,
    const solvedDirections& directions,
    const closedSurface& surface,
    const scalar bandWidth
)
:
    name_(name),
    mesh_(mesh),
    directions_(directions),
    surface_(surface),
    parameters_(surface.basis().samples()),
    samples_(parameters_.size()),
    width_(0),
    band_(0),
    centre_(directions.size())
{
    nodalVectors normals(samples_.size(), directions.size());
    forAll(samples_, i)
    {
        const surfacePoint sample = surface.expand(parameters_[i]);
        samples_[i] = directions.toPoint(sample.x);
        normals.row(i) = closedSurface::normal(sample);
    }
    centre_ = directions(boundBox(samples_, false).midpoint());

    // Geometry that the processors make together: not later, on those alone
    // that hold a part of the membrane
    mesh.C();
    mesh.nonOrthDeltaCoeffs();

    treeBoundBox bounds(samples_);
    bounds.min() -= vector::uniform(0.6*surface.meanRadius());
    bounds.max() += vector::uniform(0.6*surface.meanRadius());
    tree_.reset
    (
        new indexedOctree<treeDataPoint>
        (
            treeDataPoint(samples_), bounds, 8, 10, 3
        )
    );

    const cellSearch& search = cellSearch::New(mesh);
    const pointField& centres = search.centres();

    // Cell width: the largest of the cells that the surface runs through
    const scalar sampleSpacing = surface.sampleSpacing();
    const List<solvedVector> images
    (
        directions.images().images(centre_, directions.images().wrapped(centre_))
    );
    const auto boxAround = [&](const scalar margin, const solvedVector& image)
    {
        const vector shift(directions.toVector(image - centre_));
        boundBox box(samples_, false);
        box.min() += shift - vector::uniform(margin);
        box.max() += shift + vector::uniform(margin);
        return box;
    };
    const auto around = [&](const scalar margin)
    {
        DynamicList<label> cells;
        for (const solvedVector& i : images)
        {
            cells.append(search.inBox(boxAround(margin, i)));
        }
        Foam::inplaceUniqueSort(cells);
        return cells;
    };
    const auto findObstacles = [&](const scalar margin)
    {
        obstacles_.clear();
        for (const solvedVector& i : images)
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
        const solvedVector x = image(centres[celli]);
        const pointIndexHit hit =
            tree_->findNearest(directions.toPoint(x), sqr(h + sampleSpacing));
        if (hit.hit() && sees(directions(hit.hitPoint()), x))
        {
            width_ = max(width_, h);
        }
    }
    reduce(width_, maxOp<scalar>());

    band_ = bandWidth*width_;
    const scalar reach = band_ + sampleSpacing;
    findObstacles(reach);
    setCells(around(reach), normals, reach);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::membraneLevelSet::signedDistance
(
    const solvedVector& x,
    surfaceParameter& foot
) const
{
    solvedVector nearest = x;
    label sample = -1;
    scalar bound = sqr(GREAT);
    for (const solvedVector& image : directions_.images().images(x, centre_))
    {
        const point c = directions_.toPoint(image);
        const pointIndexHit hit = tree_->findNearest(c, bound);
        if (hit.hit())
        {
            nearest = image;
            sample = hit.index();
            bound = magSqr(hit.hitPoint() - c);
        }
    }

    foot = parameters_[sample];
    return surface_.signedDistance(nearest, foot);
}


Foam::scalar Foam::capsule::membraneLevelSet::signedDistanceFrom
(
    const solvedVector& x,
    surfaceParameter& foot
) const
{
    return surface_.signedDistance(directions_.images().image(x, centre_), foot);
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
                surfaceParameter foot;
                const scalar d = signedDistance(directions_(faces[i]), foot);
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
        surfaceParameter foot;
        field[celli] *= mag(signedDistance(directions_(mesh_.C()[celli]), foot));
    }
    forAll(field.boundaryField(), patchi)
    {
        fvPatchScalarField& pf = field.boundaryFieldRef()[patchi];
        const vectorField& faces = mesh_.C().boundaryField()[patchi];
        forAll(pf, i)
        {
            surfaceParameter foot;
            pf[i] = signedDistance(directions_(faces[i]), foot);
        }
    }

    return tfield;
}
