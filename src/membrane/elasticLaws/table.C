/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "table.H"
#include "familyEntries.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace elasticLaws
{
    defineTypeNameAndDebug(table, 0);
    addToRunTimeSelectionTable(elasticLaw, table, dictionary);
    static const familyEntries<elasticLaw> entries({"tension"});
}
}
}

const Foam::scalar Foam::capsule::elasticLaws::table::step_ = 1e-5;

const Foam::label Foam::capsule::elasticLaws::table::intervals_ = 256;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::table::value
(
    const nodalScalars& l
) const
{
    nodalScalars result(l.size());
    for (label i = 0; i < l.size(); ++i)
    {
        result(i) = tension_->value(l(i));
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::table::work
(
    const nodalScalars& l
) const
{
    // Simpson's rule
    const nodalScalars step = (l.array() - 1)/intervals_;
    nodalScalars sum = value(nodalScalars::Ones(l.size())) + value(l);
    for (label i = 1; i < intervals_; ++i)
    {
        sum += (i % 2 ? 4 : 2)*value((1 + i*step.array()).matrix());
    }
    return sum.cwiseProduct(step)/3;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::elasticLaws::table::table(const dictionary& dict, const bool)
:
    elasticLaw(dict),
    tension_
    (
        input::guarded
        (
            dict,
            "tension",
            [&]() { return Function1<scalar>::New("tension", dict); }
        )
    )
{
    const scalar atRest = input::guarded
    (
        dict, "tension", [&]() { return tension_->value(1); }
    );
    if (!(mag(atRest) <= input::largest))
    {
        FatalIOErrorInFunction(dict)
            << "Entry tension is " << atRest << " at the stretch 1; permitted: "
            << -input::largest << " to " << input::largest << " [N/m]"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::elasticLaws::table::tension
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return value(l1).cwiseQuotient(l2);
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::table::energy
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return work(l1) + work(l2);
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::table::stiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return
    (
        value((l1.array() + step_).matrix())
      - value((l1.array() - step_).matrix())
    ).cwiseQuotient(2*step_*l2);
}


Foam::capsule::nodalScalars Foam::capsule::elasticLaws::table::crossStiffness
(
    const nodalScalars& l1,
    const nodalScalars& l2
) const
{
    return -value(l1).cwiseQuotient(l2.cwiseAbs2());
}


Foam::capsule::secondPiolaStress Foam::capsule::elasticLaws::table::stress
(
    const nodalScalars&,
    const nodalScalars&
) const
{
    FatalErrorInFunction
        << "Entry type of elasticLaw is " << type() << ", a law for membranes"
        << " of a plane or a wedge: in space it is not permitted"
        << exit(FatalError);

    return secondPiolaStress(0);
}
