/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-contact

Description
    Unit tests of contact in the geometry of the case it runs in: the law; that
    forces are minus the gradient of the energy, with all gaps found anew; that
    they are opposite; their size, between surfaces and at a wall; and their
    derivative. Ends with an error if any fails.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "contact.H"
#include "solvedDirections.H"
#include "ellipsoids.H"

using namespace Foam;
using namespace Foam::capsule;

//- Range and strength
static const scalar range = 0.3;
static const scalar strength = 7;


//- A smooth displacement with the symmetry of a wedge
static nodalVectors displacement(const surfaceBasis& basis, const scalar phase)
{
    nodalVectors v(basis.size(), basis.nComponents());
    for (label i = 0; i < basis.size(); ++i)
    {
        const solvedVector d = directionOf(basis, i);
        v.row(i) = phase*d*(0.6 + d(0));
        v(i, 0) += 0.3 - phase*d(0);
        if (!basis.axisymmetric())
        {
            v(i, 1) += 0.2 + phase*sqr(d(0));
        }
    }
    return v;
}


//- A value and a derivative of it by differences, relative to a size
static void checkSlope
(
    const std::string& what,
    const scalar value,
    const scalar higher,
    const scalar lower,
    const scalar step,
    const scalar bound
)
{
    check(what, ((higher - lower)/(2*step) - value)/value, bound);
}


static void testLaw()
{
    Info<< "Law" << endl;
    const repulsion law(range, strength);
    for (const scalar part : {0.05, 0.3, 0.8})
    {
        const scalar g = part*range;
        const scalar e = 1e-5*range;
        checkSlope
        (
            "pressure against differences", -law.pressure(g),
            law.energy(g + e), law.energy(g - e), e, 1e-6
        );
        checkSlope
        (
            "stiffness against differences", -law.stiffness(g),
            law.pressure(g + e), law.pressure(g - e), e, 1e-6
        );
    }
    check("pressure at half the range", law.pressure(0.5*range) - strength, 1e-14);
    const scalar end = range*(1 - 1e-4);
    check("energy ends with its third power", law.energy(end)/strength, 1e-12);
    check("and the pressure with its second", law.pressure(end)/strength, 2e-8);
    check("none beyond", law.pressure(range) + law.stiffness(2*range), 0);
}


//- Forces of all surfaces together, and their moments; and the work of the
//  forces by displacements
static scalar work
(
    const PtrList<closedSurface>& surfaces,
    const List<nodalVectors>& forces,
    const List<nodalVectors>& v
)
{
    scalar sum = 0;
    forAll(surfaces, i)
    {
        sum += surfaces[i].integral(nodalScalars(dot(forces[i], v[i])));
    }
    return sum;
}


static PtrList<closedSurface> moved
(
    const PtrList<closedSurface>& surfaces,
    const List<nodalVectors>& v,
    const scalar step
)
{
    PtrList<closedSurface> result(surfaces.size());
    forAll(surfaces, i)
    {
        result.set
        (
            i,
            new closedSurface
            (
                surfaces[i].basis(), surfaces[i].nodes() + step*v[i]
            )
        );
    }
    return result;
}


//- Energy, force and derivative of surfaces
static void testGradient
(
    const contact& law,
    const PtrList<closedSurface>& surfaces
)
{
    List<nodalVectors> v(surfaces.size());
    forAll(surfaces, i)
    {
        v[i] = displacement(surfaces[i].basis(), i ? -0.4 : 0.7);
    }
    const contactGaps found(law.find(surfaces));
    const scalar e = 1e-5;
    const contactGaps further(law.find(moved(surfaces, v, e)));
    const contactGaps nearer(law.find(moved(surfaces, v, -e)));
    check("as many gaps", found.size() - further.size(), 0);
    atLeast("gaps", found.size(), surfaces[0].spatial() ? 20 : 5);

    const List<nodalVectors> forces(law.forces(surfaces));
    checkSlope
    (
        "force against the energy of gaps found anew",
        -work(surfaces, forces, v),
        law.energy(found, further.gaps()), law.energy(found, nearer.gaps()), e,
        1e-6
    );

    nodalMatrix change = nodalMatrix::Zero(found.size(), 1);
    forAll(surfaces, i)
    {
        found.addChange(i, surfaces[i].basis().pack(v[i]), change);
    }
    const nodalScalars dg = change;
    const nodalScalars slope =
        (
            law.forces(found, found.gaps() + e*dg)
          - law.forces(found, found.gaps() - e*dg)
        )/(2*e);
    const nodalScalars expected =
        -law.stiffness(found, found.gaps()).cwiseProduct(dg);
    check
    (
        "derivative of the forces",
        (slope - expected).norm()/expected.norm(),
        1e-6
    );
}


//- Two surfaces
static void testPair(const contact& law, const PtrList<closedSurface>& surfaces)
{
    const closedSurface& a = surfaces[0];
    const List<nodalVectors> forces(law.forces(surfaces));
    const solvedVector on = a.resultant(forces[0]);
    const solvedVector both = on + surfaces[1].resultant(forces[1]);
    check("resultants, of one of them", both.norm()/on.norm(), 1e-12);

    for (label k = 0; k < a.nRotations(); ++k)
    {
        scalar sum = 0;
        forAll(surfaces, i)
        {
            sum += surfaces[i].integral
            (
                nodalScalars(dot(turned(surfaces[i].nodes(), k), forces[i]))
            );
        }
        check("moments about the origin", sum/on.norm(), 1e-11);
    }
}


//- Two alike that face each other: the pressure of the gap, half of it by the
//  areas of the other surface, which are larger by (1 + g/a)^2 as they are seen
//  from this one, in the plane by 1 + g/a: 6 to 14 per cent
static void testPressure(const contact& law, const PtrList<closedSurface>& pair)
{
    const closedSurface& a = pair[0];
    const nodalVectors f = law.forces(pair)[0];
    const repulsion pressure(range, strength);
    const scalar middle = pair[1].nodes().col(0).mean();
    scalar largest = 0;
    for (label i = 0; i < a.size(); ++i)
    {
        // From a point to a sphere
        solvedVector d = a.nodes().row(i);
        d(0) -= middle;
        d(1) -= axisAt;
        const scalar expected = pressure.pressure(d.norm() - 0.8);
        largest = max(largest, mag(f.row(i).dot(d)/d.norm() - expected));
    }
    check
    (
        "pressure of equal spheres, of that at the least gap",
        largest/pressure.pressure(0.1),
        a.spatial() || a.axisymmetric() ? 0.14 : 0.07
    );
}


//- A surface next to a wall
static void testWall(const contact& law, const closedSurface& surface)
{
    PtrList<closedSurface> single(1);
    single.set(0, new closedSurface(surface));
    testGradient(law, single);
    if (!surface.spatial())
    {
        const nodalVectors f = law.forces(single)[0];
        const scalar gap = axisAt + 2 - surface.nodes().col(1).maxCoeff();
        check
        (
            "force at a wall, of the law",
            -f.col(1).minCoeff()/repulsion(range, strength).pressure(gap) - 1,
            1e-12
        );
    }
}


//- An ellipsoid with a waist, whose sides are 0.16 apart in the middle; about
//  an axis with a groove that wide
static nodalVectors waisted(const surfaceBasis& basis)
{
    nodalVectors nodes(basis.size(), basis.nComponents());
    for (label i = 0; i < basis.size(); ++i)
    {
        solvedVector d = directionOf(basis, i);
        const scalar side = basis.axisymmetric() ? d(1) : d(0);
        const scalar narrow = 0.08 + 0.6*sqr(side);
        d(0) *= basis.axisymmetric() ? narrow : 1;
        d(1) *= basis.axisymmetric() ? 1 : narrow;
        nodes.row(i) = d;
        nodes(i, 0) += 5;
        nodes(i, 1) += axisAt;
    }
    return nodes;
}


//- A fold: its forces are in balance, and push its sides apart
static void testFold(const contact& law, const PtrList<closedSurface>& fold)
{
    const closedSurface& surface = fold[0];
    const nodalVectors forces = law.forces(fold)[0];
    const scalar size =
        surface.integral(nodalScalars(forces.rowwise().norm()));
    check("resultant", surface.resultant(forces).norm()/size, 1e-12);
    for (label k = 0; k < surface.nRotations(); ++k)
    {
        check
        (
            "moment",
            surface.integral
            (
                nodalScalars(dot(turned(surface.nodes(), k), forces))
            )/size,
            1e-6
        );
    }
    atLeast
    (
        "pressure in the middle, over that of the law",
        dot(forces, surface.normal()).maxCoeff()
       /repulsion(range, strength).pressure(0.16),
        0.8
    );
}


int main(int argc, char* argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const solvedDirections directions(mesh);
    const autoPtr<contact> law
    (
        contact::New
        (
            dictOf("contact { type repulsion; range 0.3; strength 7; }"),
            mesh,
            directions
        )
    );
    check
    (
        "none without an entry",
        contact::New(dictOf("other 1;"), mesh, directions).valid(),
        0
    );
    testLaw();

    const autoPtr<surfaceBasis> first(basisIn(directions, 72));
    const autoPtr<surfaceBasis> second(basisIn(directions, 96));
    const bool turned = !directions.axisymmetric();
    PtrList<closedSurface> surfaces(2);

    Info<< "Pair" << endl;
    surfaces.set(0, new closedSurface(*first, ellipsoid(*first, 4.2, 0.7, 0.9)));
    surfaces.set
    (
        1,
        new closedSurface
        (
            *second, ellipsoid(*second, 5.7, 0.65, 1, turned ? 0.3 : 0)
        )
    );
    testGradient(*law, surfaces);
    testPair(*law, surfaces);

    Info<< "Equal spheres" << endl;
    surfaces.set(0, new closedSurface(*first, ellipsoid(*first, 4.2, 0.8, 0.8)));
    surfaces.set(1, new closedSurface(*first, ellipsoid(*first, 5.9, 0.8, 0.8)));
    testPressure(*law, surfaces);

    Info<< "Wall" << endl;
    testWall(*law, closedSurface(*first, ellipsoid(*first, 5, 0.8, 1.85)));

    Info<< "Fold" << endl;
    const autoPtr<contact> folding
    (
        contact::New
        (
            dictOf
            (
                "contact { type repulsion; range 0.3; strength 7; folds yes; }"
            ),
            mesh,
            directions
        )
    );
    PtrList<closedSurface> single(1);
    single.set(0, new closedSurface(*first, waisted(*first)));
    check
    (
        "no forces of folds unless asked for",
        law->forces(single)[0].norm(),
        0
    );
    testGradient(*folding, single);
    testFold(*folding, single);

    return verdict();
}


// ************************************************************************* //
