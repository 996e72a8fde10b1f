/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-stressTangent

Description
    Unit test of the derivative of the balance of stress: a correction makes up
    for an imbalance, with a force that follows the points and with one that
    stands still. Returns the number of failures.

\*---------------------------------------------------------------------------*/

#include "stressTangent.H"
#include "judgement.H"

using namespace Foam;
using namespace Foam::capsule;

//- A matrix of any entries, up to a size
static nodalMatrix anyMatrix(const label n, const scalar size)
{
    nodalMatrix m(n, n);
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            m(i, j) = size*std::sin(scalar(3 + 7*i*(j + 2) + i*i + 5*j));
        }
    }
    return m;
}


int main()
{
    const label n = 12;
    const nodalMatrix S = anyMatrix(n, 1);
    const nodalMatrix M = 0.3*S.transpose();
    const nodalMatrix J = nodalMatrix::Identity(n, n) + anyMatrix(n, 0.05);
    const nodalMatrix A = anyMatrix(n, 0.2).transpose();
    const nodalScalars residual = anyMatrix(n, 1).col(3);

    stressTangent tangent;
    tangent.setFluid(S, J);
    tangent.linearise();
    nodalScalars df = tangent.correction(residual);
    check
    (
        "correction with a force that stands still",
        (residual + tangent.restChange(df)).norm(), 1e-12
    );

    tangent.setDisplacements(M);
    tangent.linearise(A);
    df = tangent.correction(residual);
    check
    (
        "correction with a force that follows the points",
        (
            residual + tangent.restChange(df) + tangent.forceChange(M*df)
        ).norm(), 1e-10
    );
    atLeast
    (
        "what the force that follows makes of it",
        tangent.forceChange(M*df).norm()/residual.norm(), 0.1
    );
    check
    (
        "change of the rest",
        (tangent.restChange(df) + J*df).norm()/df.norm(), 1e-14
    );
    check("mobility", (tangent.mobility() - S).norm(), 0);

    return nFailed();
}
