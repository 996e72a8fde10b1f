/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "combinedResidual.H"
#include "ownership.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using Foam::label;
    using Foam::capsule::interfaceResidual;

    //- Rows that a part has of unknowns and residuals, and of responses
    label unknownsOf(const interfaceResidual& part)
    {
        return part.nUnknowns();
    }

    label responseOf(const interfaceResidual& part)
    {
        return part.nResponse();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
Foam::capsule::nodalMatrix Foam::capsule::combinedResidual::mapped
(
    const nodalMatrix& rows,
    label (*size)(const interfaceResidual&),
    const Function& map
) const
{
    std::vector<nodalMatrix> found(parts_.size());
    label start = 0;
    forAll(parts_, i)
    {
        const label n = size(parts_[i]);
        if (ownership::owns(i))
        {
            found[i] = map(parts_[i], rows.middleRows(start, n));
        }
        start += n;
    }
    ownership::share(found);

    label n = 0;
    for (const nodalMatrix& part : found)
    {
        n += part.rows();
    }
    nodalMatrix result(n, rows.cols());
    n = 0;
    for (const nodalMatrix& part : found)
    {
        result.middleRows(n, part.rows()) = part;
        n += part.rows();
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::combinedResidual::combinedResidual
(
    const UPtrList<interfaceResidual>& parts
)
:
    parts_(parts)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::capsule::combinedResidual::nUnknowns() const
{
    label n = 0;
    for (const interfaceResidual& part : parts_)
    {
        n += part.nUnknowns();
    }
    return n;
}


Foam::capsule::nodalScalars Foam::capsule::combinedResidual::unknowns() const
{
    nodalScalars x(nUnknowns());
    label start = 0;
    for (const interfaceResidual& part : parts_)
    {
        x.segment(start, part.nUnknowns()) = part.unknowns();
        start += part.nUnknowns();
    }
    return x;
}


void Foam::capsule::combinedResidual::setUnknowns(const nodalScalars& x)
{
    label start = 0;
    for (interfaceResidual& part : parts_)
    {
        part.setUnknowns(x.segment(start, part.nUnknowns()));
        start += part.nUnknowns();
    }
}


Foam::label Foam::capsule::combinedResidual::nResponse() const
{
    label n = 0;
    for (const interfaceResidual& part : parts_)
    {
        n += part.nResponse();
    }
    return n;
}


Foam::capsule::nodalScalars
Foam::capsule::combinedResidual::fluidResponse() const
{
    nodalScalars y(nResponse());
    label start = 0;
    for (const interfaceResidual& part : parts_)
    {
        y.segment(start, part.nResponse()) = part.fluidResponse();
        start += part.nResponse();
    }
    return y;
}


Foam::capsule::nodalScalars Foam::capsule::combinedResidual::residual
(
    const nodalScalars& y
) const
{
    return mapped
    (
        y,
        responseOf,
        [](const interfaceResidual& part, const nodalMatrix& yi)
        {
            return part.residual(yi);
        }
    );
}


void Foam::capsule::combinedResidual::linearise
(
    const nodalScalars& y,
    const bool fullTangent
)
{
    label start = 0;
    forAll(parts_, i)
    {
        const label n = responseOf(parts_[i]);
        if (ownership::owns(i))
        {
            parts_[i].linearise(y.segment(start, n), fullTangent);
        }
        start += n;
    }
}


Foam::scalar Foam::capsule::combinedResidual::maxStepLength
(
    const nodalScalars& dy
) const
{
    scalar result = 1;
    label start = 0;
    for (const interfaceResidual& part : parts_)
    {
        const label n = responseOf(part);
        result = min(result, part.maxStepLength(dy.segment(start, n)));
        start += n;
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::combinedResidual::residualChange
(
    const nodalMatrix& dy
) const
{
    return mapped
    (
        dy,
        responseOf,
        [](const interfaceResidual& part, const nodalMatrix& dyi)
        {
            return part.residualChange(dyi);
        }
    );
}


Foam::capsule::nodalMatrix Foam::capsule::combinedResidual::correction
(
    const nodalMatrix& residual
) const
{
    return mapped
    (
        residual,
        unknownsOf,
        [](const interfaceResidual& part, const nodalMatrix& residuali)
        {
            return part.correction(residuali);
        }
    );
}


Foam::capsule::nodalMatrix Foam::capsule::combinedResidual::responseChanges
(
    const nodalMatrix& dx
) const
{
    return mapped
    (
        dx,
        unknownsOf,
        [](const interfaceResidual& part, const nodalMatrix& dxi)
        {
            nodalMatrix result(part.nResponse(), dxi.cols());
            for (Eigen::Index j = 0; j < dxi.cols(); ++j)
            {
                result.col(j) = part.responseChange(dxi.col(j));
            }
            return result;
        }
    );
}
