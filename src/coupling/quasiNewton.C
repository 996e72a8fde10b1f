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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::couplingMethods::quasiNewton::start()
{
    lastx_.resize(0);
    dx_.resize(0, 0);
    dr_.resize(0, 0);
}


Foam::capsule::nodalScalars Foam::capsule::couplingMethods::quasiNewton::next
(
    const nodalScalars& x,
    const nodalScalars& r
)
{
    if (lastx_.size())
    {
        const Eigen::Index k = dx_.cols();
        dx_.conservativeResize(x.size(), k + 1);
        dr_.conservativeResize(x.size(), k + 1);
        dx_.col(k) = x - lastx_;
        dr_.col(k) = r - lastr_;
    }
    lastx_ = x;
    lastr_ = r;

    if (dx_.cols() == 0)
    {
        return x + r;
    }

    // Columns of one length, so that the rank decision compares directions
    const nodalScalars length =
        dr_.colwise().norm().cwiseMax(VSMALL).cwiseInverse();
    Eigen::ColPivHouseholderQR<nodalMatrix> qr(dr_*length.asDiagonal());
    qr.setThreshold(1e-8);
    const nodalScalars a = length.cwiseProduct(nodalScalars(qr.solve(-r)));

    return x + dx_*a + (r + dr_*a);
}
