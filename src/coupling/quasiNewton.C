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
    class combination
    {
        nodalScalars length_;
        Eigen::ColPivHouseholderQR<nodalMatrix> qr_;

    public:

        explicit combination(const nodalMatrix& R)
        {
            if (R.cols() > 0)
            {
                // Columns of one length, so that the rank decision compares
                // directions
                length_ = R.colwise().norm().cwiseMax(VSMALL).cwiseInverse();
                qr_.setThreshold(1e-8);
                qr_.compute(R*length_.asDiagonal());
            }
        }

        nodalScalars operator()(const nodalScalars& r) const
        {
            return
                length_.size()
              ? nodalScalars(length_.cwiseProduct(nodalScalars(qr_.solve(-r))))
              : length_;
        }
    };
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
    combination best(R);
    tangent known = earlier;
    scalar left = 1;
    for (label i = 0; i < maxSteps_ && left > innerTolerance_; ++i)
    {
        const nodalScalars a = best(r);
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
            best = combination(R);
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
