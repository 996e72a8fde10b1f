/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "quasiNewton.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace couplingMethods
{
    defineTypeNameAndDebug(quasiNewton, 0);
    addToRunTimeSelectionTable(couplingMethod, quasiNewton, dictionary);
}
}
}

const Foam::scalar Foam::capsule::couplingMethods::quasiNewton::innerTolerance_ = 0.03;
const Foam::label Foam::capsule::couplingMethods::quasiNewton::maxSteps_ = 20;
const Foam::scalar Foam::capsule::couplingMethods::quasiNewton::maxContraction_ = 0.7;
const Foam::scalar Foam::capsule::couplingMethods::quasiNewton::minDamping_ = 0.05;


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using namespace Foam;
    using namespace Foam::capsule;

    //- Which derivative of the membranes' forces a Newton step is taken with:
    //  one found earlier; that at the present response without what makes waves
    //  grow; the full one
    enum tangent { earlier, stable, full };

    //- The a that makes |r + R a| least
    nodalScalars combination(const nodalMatrix& R, const nodalScalars& r)
    {
        if (R.cols() == 0)
        {
            return nodalScalars(0);
        }

        // Columns of one length, so that the rank decision compares directions
        const nodalScalars length =
            R.colwise().norm().cwiseMax(VSMALL).cwiseInverse();
        Eigen::ColPivHouseholderQR<nodalMatrix> qr(R*length.asDiagonal());
        qr.setThreshold(1e-8);
        return length.cwiseProduct(nodalScalars(qr.solve(-r)));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::couplingMethods::quasiNewton::learn
(
    const nodalScalars& x,
    const nodalScalars& y
)
{
    if (lastx_.size() == 0)
    {
        dx_.resize(x.size(), 0);
        dy_.resize(y.size(), 0);
    }
    else
    {
        const Eigen::Index k = dx_.cols();
        dx_.conservativeResize(x.size(), k + 1);
        dy_.conservativeResize(y.size(), k + 1);
        dx_.col(k) = x - lastx_;
        dy_.col(k) = y - lasty_;
    }
    lastx_ = x;
    lasty_ = y;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::couplingMethods::quasiNewton::start()
{
    lastx_.resize(0);
    dx_.resize(0, 0);
    dy_.resize(0, 0);
}


Foam::capsule::nodalScalars Foam::capsule::couplingMethods::quasiNewton::next
(
    const nodalScalars& x,
    interfaceResidual& problem
)
{
    nodalScalars y = problem.fluidResponse();
    learn(x, y);

    const auto stepAt = [&](const nodalScalars& response)
    {
        return nodalScalars(problem.correction(problem.residual(response)));
    };
    const auto learnt = [&]()
    {
        return problem.correction(problem.residualChange(dy_));
    };

    nodalScalars result = x;
    nodalScalars r = stepAt(y);
    nodalMatrix R = learnt();
    tangent known = earlier;
    scalar left = 1;
    for (label i = 0; i < maxSteps_ && left > innerTolerance_; ++i)
    {
        const nodalScalars a = combination(R, r);
        const nodalScalars t = r + R*a;
        const nodalScalars dy = dy_*a + problem.responseChange(t);

        scalar part = problem.maxStepLength(dy);
        nodalScalars next = stepAt(y + part*dy);
        const auto falls = [&](const scalar wanted)
        {
            return next.norm() < (1 - wanted*part)*r.norm();
        };
        while (known != earlier && !falls(0.5) && part > minDamping_)
        {
            part *= 0.5;
            next = stepAt(y + part*dy);
        }
        if (known != full && !falls(known == earlier ? maxContraction_ : 0.5))
        {
            known = known == earlier ? stable : full;
            problem.linearise(y, known == full);
            r = stepAt(y);
            R = learnt();
            continue;
        }

        left *= next.norm()/(r.norm() + VSMALL);
        result += part*(dx_*a + t);
        y += part*dy;
        r = next;
        known = earlier;
    }
    return result;
}
