/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "contactResidual.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Bodies as residuals
static Foam::UPtrList<Foam::capsule::interfaceResidual> partsOf
(
    Foam::UPtrList<Foam::capsule::contactBody>& bodies
)
{
    using namespace Foam;

    UPtrList<capsule::interfaceResidual> parts(bodies.size());
    forAll(bodies, i)
    {
        parts.set(i, &bodies[i]);
    }
    return parts;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalScalars Foam::capsule::contactResidual::gapsAt
(
    const nodalScalars& y
) const
{
    nodalMatrix gaps = gaps_.gaps();
    label start = 0;
    for (label i = 0; implicit_ && i < bodies_.size(); ++i)
    {
        const contactBody& body = bodies_[i];
        const label n = body.nResponse();
        const nodalVectors moved =
            body.pointsOf(y.segment(start, n)) - gaps_.points()[i];
        gaps_.addChange(i, body.surface().basis().pack(moved), gaps);
        start += n;
    }
    return gaps;
}


Foam::capsule::nodalMatrix Foam::capsule::contactResidual::gapsChange
(
    const nodalMatrix& dy
) const
{
    nodalMatrix gaps = nodalMatrix::Zero(gaps_.size(), dy.cols());
    label start = 0;
    forAll(bodies_, i)
    {
        const contactBody& body = bodies_[i];
        const label n = body.nResponse();
        gaps_.addChange(i, body.pointsChange(dy.middleRows(start, n)), gaps);
        start += n;
    }
    return gaps;
}


Foam::capsule::nodalMatrix Foam::capsule::contactResidual::expectedChange
(
    const nodalMatrix& dx
) const
{
    return gapsChange(responseChanges(dx));
}


void Foam::capsule::contactResidual::linearise()
{
    closed_.clear();
    for (label j = 0; j < stiffness_.size(); ++j)
    {
        if (stiffness_(j) > 0)
        {
            closed_.append(j);
        }
    }
    const label m = closed_.size();
    if (!useResponse_ || m == 0)
    {
        return;
    }

    nodalMatrix load(load_.rows(), m);
    nodalScalars stiffness(m);
    for (label j = 0; j < m; ++j)
    {
        load.col(j) = load_.col(closed_[j]);
        stiffness(j) = stiffness_(closed_[j]);
    }
    answer_ = combinedResidual::correction(load);
    const nodalMatrix change = expectedChange(answer_);
    nodalMatrix system = nodalMatrix::Identity(m, m);
    for (label j = 0; j < m; ++j)
    {
        system.row(j) += stiffness(j)*change.row(closed_[j]);
    }
    system_.compute(system);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::contactResidual::contactResidual
(
    const contact& law,
    UPtrList<contactBody>& bodies
)
:
    combinedResidual(partsOf(bodies)),
    contact_(law),
    bodies_(bodies),
    implicit_(true),
    useResponse_(true)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::contactResidual::find
(
    const PtrList<closedSurface>& predicted
)
{
    gaps_ = contact_.find(predicted);
}


void Foam::capsule::contactResidual::start
(
    const bool implicit,
    const bool useResponse
)
{
    if (!active())
    {
        return;
    }
    implicit_ = implicit;
    useResponse_ = implicit && useResponse;

    load_.resize(nUnknowns(), gaps_.size());
    label start = 0;
    forAll(bodies_, i)
    {
        const contactBody& body = bodies_[i];
        const surfaceBasis& basis = body.surface().basis();
        const label n = basis.nComponents()*basis.nPacked();
        const nodalScalars area = body.surface().areaElement();
        nodalMatrix forces = gaps_.derivatives(i, n);
        for (label j = 0; j < forces.cols(); ++j)
        {
            forces.col(j) = basis.pack
            (
                contactGaps::perArea(basis, area, forces.col(j))
            );
        }
        load_.middleRows(start, body.nUnknowns()) = body.loaded(forces);
        start += body.nUnknowns();
    }
    stiffness_ = contact_.stiffness(gaps_, gaps_.gaps());
    linearise();
}


Foam::capsule::nodalScalars Foam::capsule::contactResidual::residual
(
    const nodalScalars& y
) const
{
    nodalScalars result = combinedResidual::residual(y);
    if (active())
    {
        result += load_*contact_.forces(gaps_, gapsAt(y));
    }
    return result;
}


void Foam::capsule::contactResidual::linearise
(
    const nodalScalars& y,
    const bool fullTangent
)
{
    combinedResidual::linearise(y, fullTangent);
    if (active() && implicit_)
    {
        stiffness_ = contact_.stiffness(gaps_, gapsAt(y));
        linearise();
    }
}


Foam::capsule::nodalMatrix Foam::capsule::contactResidual::residualChange
(
    const nodalMatrix& dy
) const
{
    nodalMatrix result = combinedResidual::residualChange(dy);
    if (active() && implicit_ && dy.cols())
    {
        result -= load_*(stiffness_.asDiagonal()*gapsChange(dy));
    }
    return result;
}


Foam::capsule::nodalMatrix Foam::capsule::contactResidual::correction
(
    const nodalMatrix& residual
) const
{
    nodalMatrix result = combinedResidual::correction(residual);
    if (active() && useResponse_ && closed_.size() && residual.cols())
    {
        const nodalMatrix change = expectedChange(result);
        nodalMatrix forces(closed_.size(), residual.cols());
        forAll(closed_, j)
        {
            forces.row(j) = stiffness_(closed_[j])*change.row(closed_[j]);
        }
        result -= answer_*system_.solve(forces);
    }
    return result;
}


// ************************************************************************* //
