/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "opposedForces.H"
#include "input.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace loads
{
    defineTypeNameAndDebug(opposedForces, 0);
    addToRunTimeSelectionTable(membraneLoad, opposedForces, dictionary);
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::solvedVector Foam::capsule::loads::opposedForces::readDirection
(
    const solvedDirections& directions
) const
{
    const vector given(input::get<vector>(dict_, "direction"));
    const vector kept = directions.conserved(given);

    if (!(mag(given) > 0) || mag(given - kept) > 1e-6*mag(given))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry direction is " << given << "; permitted: a vector of any"
            << " length, in a plane mesh in the plane, in a wedge along the"
            << " axis" << exit(FatalIOError);
    }
    return directions(kept/mag(kept));
}


void Foam::capsule::loads::opposedForces::checkContact
(
    const closedSurface& initial
) const
{
    const scalar least = 2*initial.basis().spacing()*initial.meanRadius();
    const scalar most = initial.meanRadius();

    if (!(contactDiameter_ >= least && contactDiameter_ <= most))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry contactDiameter is " << contactDiameter_
            << "; for this membrane " << least << " to " << most
            << " [m] are permitted, from two distances of nodes to half the"
            << " diameter" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::loads::opposedForces::opposedForces
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    dict_(dict),
    time_(mesh.time()),
    direction_(readDirection(solvedDirections(mesh))),
    force_
    (
        input::guarded
        (
            dict,
            "force",
            [&]()
            {
                return Function1<scalar>::New("force", dict);
            }
        )
    ),
    contactDiameter_
    (
        input::getPositive(dict, "contactDiameter", dimLength, "m")
    )
{
    input::permit
    (
        dict,
        {"type", "direction", "force", "forceCoeffs", "contactDiameter"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::loads::opposedForces::setReference
(
    const closedSurface& initial
)
{
    checkContact(initial);

    const nodalVectors x = initial.nodes().rowwise() - initial.centroid();
    const nodalScalars along = x*direction_.transpose();
    const nodalScalars r2 =
        (x - along*direction_).rowwise().squaredNorm();
    const nodalScalars patch =
        (-2*r2/sqr(0.5*contactDiameter_)).array().exp().matrix();

    // Once for either side
    nodalScalars density(nodalScalars::Zero(initial.size()));
    for (const scalar side : {1.0, -1.0})
    {
        const nodalScalars here =
            (side*along.array() > 0).select(patch, 0.0);
        density += side/initial.integral(here)*here;
    }
    unit_ = density.cwiseProduct(initial.areaElement())*direction_;
    if (initial.spatial())
    {
        // What the points can take up
        unit_ = initial.basis().symmetric(unit_);
    }
}


Foam::capsule::nodalVectors Foam::capsule::loads::opposedForces::force
(
    const closedSurface& surface
) const
{
    const scalar F = force_->value(time_.timeOutputValue());

    return F*scaled(surface.areaElement().cwiseInverse(), unit_);
}


// ************************************************************************* //
