/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneSystem.H"
#include "ownership.H"
#include "rigidBody.H"
#include "kineticEnergyRate.H"
#include "profiling.H"
#include "fileOperation.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::membraneSystem::maxOffset_ = 2;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::membraneSystem::shareUnresolved()
{
    std::vector<nodalMatrix> responses(parts_.size());
    forAll(parts_, i)
    {
        if (ownership::owns(i))
        {
            responses[i] = parts_[i].unresolvedResponse();
        }
    }
    ownership::share(responses);
    forAll(parts_, i)
    {
        parts_[i].setUnresolvedResponse(responses[i]);
    }
}


Foam::capsule::immersedBody::imbalance
Foam::capsule::membraneSystem::remaining
(
    const combinedResidual& residual
) const
{
    const nodalScalars left = residual.residual(residual.fluidResponse());
    const nodalScalars change = residual.correction(left);

    std::vector<nodalMatrix> found(parts_.size());
    label start = 0;
    forAll(parts_, i)
    {
        const label n = parts_[i].nUnknowns();
        if (ownership::owns(i))
        {
            const immersedBody::imbalance part = parts_[i].remaining
            (
                left.segment(start, n), change.segment(start, n)
            );
            found[i].resize(1, 2);
            found[i] << part.stress, part.displacement;
        }
        start += n;
    }
    ownership::share(found);

    immersedBody::imbalance result{0, 0};
    for (const nodalMatrix& part : found)
    {
        result.stress = max(result.stress, part(0));
        result.displacement = max(result.displacement, part(1));
    }
    return result;
}


Foam::PtrList<Foam::capsule::closedSurface>
Foam::capsule::membraneSystem::predictedSurfaces() const
{
    PtrList<closedSurface> surfaces(parts_.size());
    forAll(parts_, i)
    {
        surfaces.set(i, new closedSurface(parts_[i].predictedSurface()));
    }
    return surfaces;
}


void Foam::capsule::membraneSystem::place
(
    const PtrList<closedSurface>& predicted
)
{
    // What cannot be placed is an error on all processors alike
    const bool throwing = FatalError.throwExceptions();
    try
    {
        forAll(parts_, i)
        {
            ++nMoved_;
            parts_[i].predict(predicted[i], *method_);
        }
        placed_ = true;
    }
    catch (const Foam::error& wrong)
    {
        failure_ =
            parts_[nMoved_ - 1].called()
          + " cannot be placed: " + wrong.message();
    }
    FatalError.throwExceptions(throwing);
}


void Foam::capsule::membraneSystem::setJacobians()
{
    // Not where they are placed, which is the work of all processors together
    forAll(parts_, i)
    {
        if (ownership::owns(i))
        {
            parts_[i].setJacobians(*method_);
        }
    }
    if (contact_.valid())
    {
        contactResidual_->start
        (
            method_->implicitStress(), method_->usesResponse()
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::capsule::rigidBody& Foam::capsule::membraneSystem::body
(
    const label i
) const
{
    return refCast<const rigidBody>(parts_[nMembranes_ + i]);
}


void Foam::capsule::membraneSystem::predict()
{
    iter_ = 0;
    nMoved_ = 0;
    placed_ = converged_ = (size() == 0);
    if (placed_)
    {
        return;
    }

    addProfiling(predict, "capsule::membraneSystem::predict");

    const PtrList<closedSurface> predicted(predictedSurfaces());
    failure_ = resolution_->predictedObstacle(predicted);
    if (!failure_.empty())
    {
        return;
    }
    if (contact_.valid())
    {
        contactResidual_->find(predicted);
    }
    place(predicted);
    if (placed_)
    {
        fluid_.setStep();
        setJacobians();
        method_->start();
    }
}


bool Foam::capsule::membraneSystem::loop()
{
    if (size() == 0)
    {
        // One solution of the fluid alone
        return iter_++ == 0;
    }

    if (!converged_ && iter_ == maxIter_)
    {
        failure_ =
            "the membranes have not converged in " + Foam::name(iter_)
          + " iterations";
    }
    if (converged_ || !failure_.empty())
    {
        if (iter_ > 0)
        {
            Info<< "Membranes: " << (converged_ ? "converged" : "NOT converged")
                << " in " << iter_ << " iterations" << endl;
        }
        return false;
    }

    ++iter_;
    fluid_.setSources();
    return true;
}


void Foam::capsule::membraneSystem::correct(const bool solved)
{
    if (size() == 0)
    {
        return;
    }

    addProfiling(correct, "capsule::membraneSystem::correct");

    const solvedVector driving = directions_(fluid_.driving().force());
    scalar offset = 0;

    shareUnresolved();
    for (immersedBody& m : parts_)
    {
        m.correct(fluid_.U(), fluid_.scaledPressure(), driving);
        offset = max(offset, m.offset());
    }
    combinedResidual& residual =
        contact_.valid() ? *contactResidual_ : *residual_;
    const immersedBody::imbalance left = remaining(residual);
    Info<< "Membranes: iteration " << iter_ << ", imbalance of stress "
        << left.stress << ", displacement " << left.displacement
        << " cell widths" << endl;

    // That of stress is relative, and a membrane may have next to none
    if (!(left.stress < ROOTVGREAT && left.displacement < input::largest))
    {
        failure_ = "the membranes diverge";
        return;
    }

    converged_ =
        solved
     && left.stress < stressTolerance_
     && left.displacement < displacementTolerance_;

    if (converged_ && offset > maxOffset_)
    {
        converged_ = false;
        failure_ =
            "a membrane ends " + Foam::name(offset) + " cell widths from where"
            " it was predicted";
        return;
    }

    if (!converged_ && iter_ < maxIter_)
    {
        addProfiling(next, "capsule::couplingMethod::next");

        residual.setUnknowns(method_->next(residual.unknowns(), residual));
    }
}


Foam::List<Foam::capsule::nodalVectors>
Foam::capsule::membraneSystem::contactForces() const
{
    PtrList<closedSurface> surfaces(parts_.size());
    forAll(parts_, i)
    {
        surfaces.set(i, new closedSurface(parts_[i].presentSurface()));
    }
    return contact_->forces(surfaces);
}


void Foam::capsule::membraneSystem::setInsideOfBodies(surfaceScalarField& phi)
{
    for (label i = nMembranes_; i < parts_.size(); ++i)
    {
        parts_[i].setInside(fluid_.U(), phi);
    }
}


void Foam::capsule::membraneSystem::restore()
{
    for (label i = 0; i < nMoved_; ++i)
    {
        parts_[i].restore();
    }
    if (nMoved_ > 0)
    {
        fluid_.setScale();
    }
    nMoved_ = 0;
    placed_ = false;
}


bool Foam::capsule::membraneSystem::read()
{
    WarningInFunction
        << objectPath() << " has been changed: it is read at the start of a run"
        << " only, the run goes on as it was; restart it for the change to"
        << " count" << endl;
    for (const label watch : watchIndices())
    {
        fileHandler().setUnmodified(watch);
    }
    return true;
}


void Foam::capsule::membraneSystem::write() const
{
    if (size())
    {
        resolution_->warn();
    }
    for (const immersedBody& m : parts_)
    {
        m.write();
    }
    kineticEnergyRate::write(fluid_.U(), fluid_.density());
}
