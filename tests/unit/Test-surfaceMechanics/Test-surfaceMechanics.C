/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-surfaceMechanics

Description
    Unit tests of the mechanics of a membrane in space: energy, force and
    Jacobian of the elastic laws and of bending against each other, exact values
    and those of an independent code. Returns the number of failures.

\*---------------------------------------------------------------------------*/

#include "derivativeTests.H"
#include "elasticTests.H"
#include "bendingTests.H"
#include "viscosityTests.H"

using namespace Foam;
using namespace Foam::capsule;

int main()
{
    testProducts();
    for (const testLaw& law : laws())
    {
        testStress(law.entries);
        testInflation(law.entries);
        testDerivatives(law.entries, noBending, law.hasEnergy);
    }
    testAffine();
    testDrop();
    testIndependent();
    for (const label i : {0, 1, 2, 3})
    {
        testCompression(laws()[i].entries);
        testRemoved(laws()[i].entries);
    }

    for (const char* reference : {"initial", "none", "1.3"})
    {
        testDerivatives(noTension, bendingOf(reference), true);
        testPositivePart(reference);
    }
    testDerivatives(laws()[2].entries, bendingOf("initial"), true);
    testBentSphere();
    testBentWaves();
    testFlatReference();
    testIndependentBending();

    testGrowingSphere();
    testDissipation();
    for (const std::string& law : {noTension, laws()[2].entries})
    {
        testViscousJacobian(law);
    }
    testViscousCompression();

    return nFailed();
}


// ************************************************************************* //
