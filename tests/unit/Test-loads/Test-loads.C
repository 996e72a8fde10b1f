/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-loads

Description
    Unit tests of loads of membranes in the geometry of the case it runs in: of
    opposedForces the force of either patch, where it acts, that it is the same
    when the membrane is stretched, and its history. Ends with an error if any
    fails.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "membraneLoad.H"
#include "solvedDirections.H"
#include "sphericalBasis.H"
#include "mathematicalConstants.H"
#include "../Test-mechanics/testing.H"

using namespace Foam;
using namespace Foam::capsule;

//- A basis in the geometry of a mesh
static autoPtr<surfaceBasis> basisIn(const solvedDirections& directions)
{
    return
        directions.spatial()
      ? autoPtr<surfaceBasis>(new sphericalBasis(16, 24))
      : surfaceBasis::New(directions, 96);
}


//- A circle or sphere of radius 1 about (5, axisAt), stretched along the first
//  direction
static nodalVectors sphere(const surfaceBasis& basis, const scalar stretch)
{
    nodalVectors x(basis.size(), basis.nComponents());
    for (label i = 0; i < basis.size(); ++i)
    {
        const surfaceParameter y = basis.parameter(i);
        if (basis.spatial())
        {
            x.row(i) << y.x(), y.y(), y.z();
        }
        else
        {
            const scalar theta = basis.curve().start() + y.x();
            x.row(i) << std::cos(theta), std::sin(theta);
        }
    }
    x.col(0) = (5 + stretch*x.col(0).array()).matrix();
    x.col(1).array() += axisAt;
    return x;
}


//- The load on a surface whose reference is the circle or sphere
static void testForces(const membraneLoad& load, const closedSurface& s)
{
    const nodalVectors f = load.force(s);
    const nodalScalars along = f.col(0);
    const nodalScalars x = (s.nodes().col(0).array() - 5).matrix();
    const nodalScalars right =
        (x.array() > 0).select(along, nodalScalars::Zero(s.size()));

    check("resultant", s.integral(along), 1e-12);
    check
    (
        "force of the patch behind",
        s.integral(right) + 3,
        s.spatial() ? 1e-2 : 1e-12
    );
    check
    (
        "forces across",
        f.rightCols(f.cols() - 1).cwiseAbs().maxCoeff(),
        1e-12
    );
}


//- Where it acts: the mean square of the distance from the line. In space the
//  harmonics of degree 16 widen the patch
static void testPlace(const membraneLoad& load, const closedSurface& s)
{
    nodalVectors d = s.nodes();
    d.col(1).array() -= axisAt;
    const nodalScalars r2 = d.rightCols(d.cols() - 1).rowwise().squaredNorm();
    const nodalScalars behind =
        (d.col(0).array() > 5).select(load.force(s).col(0), 0.0);

    // Over the angle from the line; of a sphere with the circle there
    scalar moment = 0;
    scalar whole = 0;
    const label n = 20000;
    for (label i = 0; i < n; ++i)
    {
        const scalar theta = 0.5*constant::mathematical::pi*(i + 0.5)/n;
        const scalar r = std::sin(theta);
        const scalar w =
            std::exp(-2*sqr(r/0.4))
           *(s.spatial() || s.axisymmetric() ? r : 1);
        whole += w;
        moment += w*sqr(r);
    }
    // In the plane as far as 4e-6 of the force lie half way round
    const scalar mean = s.integral(nodalScalars(behind.cwiseProduct(r2)))/(-3);
    check
    (
        "mean square of the distance from the line",
        mean/(moment/whole) - 1,
        s.spatial() ? 0.05 : 1e-4
    );
}


int main(int argc, char* argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const solvedDirections directions(mesh);
    const autoPtr<surfaceBasis> basis(basisIn(directions));
    const closedSurface initial(*basis, sphere(*basis, 1));

    autoPtr<membraneLoad> load
    (
        membraneLoad::New
        (
            dictOf
            (
                "type opposedForces; direction (-2 0 0); contactDiameter 0.8;"
                " force table ((0 0) (1 -6));"
            ),
            mesh
        )
    );
    load->setReference(initial);
    check("no force at time 0", load->force(initial).cwiseAbs().maxCoeff(), 0);

    runTime.setTime(0.5, 1);
    Info<< "Reference" << endl;
    testForces(*load, initial);
    testPlace(*load, initial);
    Info<< "Stretched" << endl;
    testForces(*load, closedSurface(*basis, sphere(*basis, 1.7)));

    return verdict();
}


// ************************************************************************* //
