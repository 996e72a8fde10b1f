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


Foam::boundBox Foam::capsule::membraneLevelSet::box() const
{
    return boundBox
    (
        directions_.toPoint(samples_.colwise().minCoeff()),
        directions_.toPoint(samples_.colwise().maxCoeff())
    );
}


Foam::boundBox Foam::capsule::membraneLevelSet::box
(
    const solvedVector& image,
    const scalar margin
) const
{
    const vector shift(directions_.toVector(image - centre_));
    boundBox result(box());
    result.min() += shift - vector::uniform(margin);
    result.max() += shift + vector::uniform(margin);
    return result;
}


Foam::DynamicList<Foam::label> Foam::capsule::membraneLevelSet::cellsAround
(
    const UList<solvedVector>& images,
    const scalar margin
) const
{
    const cellSearch& search = cellSearch::New(mesh_);
    DynamicList<label> cells;
    for (const solvedVector& image : images)
    {
        cells.append(search.inBox(box(image, margin)));
    }
    Foam::inplaceUniqueSort(cells);
    return cells;
}


void Foam::capsule::membraneLevelSet::findObstacles
(
    const UList<solvedVector>& images,
    const scalar margin
)
{
    obstacles_.clear();
    for (const solvedVector& image : images)
    {
        lineOfSight::New(mesh_).append
        (
            box(image, margin), centre_ - image, obstacles_
        );
    }
}


void Foam::capsule::membraneLevelSet::setWidth
(
    const UList<solvedVector>& images
)
{
    const cellSearch& search = cellSearch::New(mesh_);
    const pointField& centres = search.centres();
    const scalar sampleSpacing = surface_.sampleSpacing();
    const scalar margin = search.largestWidth() + sampleSpacing;

    findObstacles(images, margin);
    for (const label celli : cellsAround(images, margin))
    {
        const scalar h = search.ofCell(celli).largest();
        if (h <= width_)
        {
            continue;
        }
        const solvedVector x = image(centres[celli]);
        scalar bound = sqr(h + sampleSpacing);
        const label sample = search_.nearest(x, bound);
        if (sample != -1 && sees(samples_.row(sample), x))
        {
            width_ = max(width_, h);
        }
    }
    reduce(width_, maxOp<scalar>());
}


bool Foam::capsule::membraneLevelSet::farInside(const solvedVector& x) const
{
    const label sample = search_.nearest(x);
    const surfacePoint p = surface_.expand(surface_.basis().samples()[sample]);
    return (x - p.x).dot(closedSurface::normal(p)) < 0;
}


void Foam::capsule::membraneLevelSet::setCells
(
    const UList<label>& candidates,
    const scalar reach
)
{
    const pointField& centres = cellSearch::New(mesh_).centres();
    const boundBox box(this->box());
    DynamicList<scalar> distances;
    solvedVector last;
    bool inside = false;

    for (const label celli : candidates)
    {
        const solvedVector x = image(centres[celli]);
        scalar bound = sqr(reach);
        const label sample = search_.nearest(x, bound);
        if (sample != -1)
        {
            surfaceParameter foot = surface_.basis().samples()[sample];
            const scalar distance = surface_.signedDistance(x, foot);
            cells_.append(celli);
            feet_.append(foot);
            distances.append(distance);
            inside = (distance < 0);
        }
        else if (last.size() == 0 || (x - last).squaredNorm() > sqr(band_))
        {
            inside = box.contains(directions_.toPoint(x)) && farInside(x);
        }
        // Else the surface, further off than the band is wide, does not pass
        // between the cell and the last one

        if (inside)
        {
            inside_.append(celli);
        }
        last = x;
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
    samples_(surface.sampled()),
    search_(samples_),
    width_(0),
    band_(0),
    centre_(directions.size())
{
    centre_ = directions(box().midpoint());

    // Geometry that the processors make together: not later, on those alone
    // that hold a part of the membrane
    mesh.C();
    mesh.nonOrthDeltaCoeffs();

    const List<solvedVector> images
    (
        directions.images().images
        (
            centre_, directions.images().wrapped(centre_)
        )
    );
    setWidth(images);

    band_ = bandWidth*width_;
    const scalar reach = band_ + surface.sampleSpacing();
    findObstacles(images, reach);
    setCells(cellsAround(images, reach), reach);
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
    scalar bound = GREAT*GREAT;
    for (const solvedVector& image : directions_.images().images(x, centre_))
    {
        const label closer = search_.nearest(image, bound);
        if (closer != -1)
        {
            nearest = image;
            sample = closer;
        }
    }

    foot = surface_.basis().samples()[sample];
    return surface_.signedDistance(nearest, foot);
}


Foam::scalar Foam::capsule::membraneLevelSet::signedDistanceFrom
(
    const solvedVector& x,
    surfaceParameter& foot
) const
{
    return
        surface_.signedDistance(directions_.images().image(x, centre_), foot);
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
        field[celli] *=
            mag(signedDistance(directions_(mesh_.C()[celli]), foot));
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
