/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rigidMotion.H"
#include "solvedDirections.H"
#include "input.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::capsule::rigidMotion::kind>
Foam::capsule::rigidMotion::kindNames_
({
    { kind::free, "free" },
    { kind::held, "held" },
    { kind::prescribed, "prescribed" },
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::rigidMotion::kind Foam::capsule::rigidMotion::kindOf
(
    const dictionary& dict
)
{
    return kindNames_[input::choice(dict, "type", kindNames_.toc())];
}


Foam::autoPtr<Foam::Function1<Foam::vector>>
Foam::capsule::rigidMotion::function(const word& entry) const
{
    if (!dict_.found(entry))
    {
        return autoPtr<Function1<vector>>();
    }
    return input::guarded
    (
        dict_,
        entry,
        [&]() { return Function1<vector>::New(entry, dict_); }
    );
}


void Foam::capsule::rigidMotion::check
(
    const word& entry,
    const vector& value,
    const vector& permitted
) const
{
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if
        (
            !(mag(value[d]) <= input::largest)
         || (value[d] != 0 && permitted[d] == 0)
        )
        {
            FatalIOErrorInFunction(dict_)
                << "Entry " << entry << " is " << value
                << "; permitted in this geometry: numbers up to "
                << input::largest << ", other than 0 only where "
                << permitted << " has a 1" << exit(FatalIOError);
        }
    }
}


Foam::capsule::nodalScalars Foam::capsule::rigidMotion::at
(
    const scalar time
) const
{
    const vector linear(linear_.valid() ? linear_->value(time) : vector(Zero));
    const vector angular
    (
        angular_.valid() ? angular_->value(time) : vector(Zero)
    );
    const direction first = directions_.axis(0);
    const direction second = directions_.axis(1);
    const direction across = directions_.axis(2);

    vector along(vector::one);
    vector about(vector::one);
    if (!directions_.spatial())
    {
        along[across] = 0;
        about[first] = about[second] = 0;
    }
    if (directions_.axisymmetric())
    {
        along[second] = 0;
        about[across] = 0;
    }
    check(linearName(), linear, along);
    check(angularName(), angular, about);

    if (directions_.axisymmetric())
    {
        return nodalScalars::Constant(1, linear[first]);
    }
    const label n = directions_.size();
    nodalScalars result(n + (n == 3 ? 3 : 1));
    result.head(n) = directions_(linear).transpose();
    if (n == 3)
    {
        result.tail(n) = directions_(angular).transpose();
    }
    else
    {
        // From the first to the second direction
        result(n) = ((first + 1) % 3 == second ? 1 : -1)*angular[across];
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::rigidMotion::rigidMotion
(
    const dictionary& dict,
    const solvedDirections& directions,
    const scalar start
)
:
    dict_(dict),
    directions_(directions),
    kind_(kindOf(dict_)),
    density_(0)
{
    wordList permitted({"type"});
    if (free())
    {
        permitted.append("density");
        density_ = input::getPositive(dict_, "density", dimDensity, "kg/m3");
    }
    if (kind_ != kind::held)
    {
        permitted.append(linearName());
        permitted.append(angularName());
        for (const word& name : {linearName(), angularName()})
        {
            permitted.append(name + "Coeffs");
        }
        linear_ = function(linearName());
        angular_ = function(angularName());
    }
    input::permit(dict_, permitted);
    at(start);
}

// ************************************************************************* //
