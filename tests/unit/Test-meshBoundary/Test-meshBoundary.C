/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-meshBoundary

Description
    Unit tests of what the boundary of a mesh says about balls, that is circles
    in the plane, and lines between points, against what is known of a channel
    with a post, a stone and a baffle. Ends with an error if any fails.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "Random.H"
#include "mathematicalConstants.H"
#include "testing.H"
#include "channelMesh.H"
#include "clearance.H"
#include "curveBasis.H"
#include "lineOfSight.H"
#include "sphericalBasis.H"

using namespace Foam;
using namespace Foam::capsule;
using constant::mathematical::pi;

//- Points of a ball, with its normals in space; 0.1 of its radius apart
static surfaceSamples ball
(
    const solvedDirections& directions,
    const point& centre,
    const scalar radius
)
{
    DynamicList<vector> normals;
    const label n = 64;
    for (label i = 0; directions.spatial() && i <= n/2; ++i)
    {
        const scalar theta = 2*pi*i/n;
        for (label j = 0; j < (i % (n/2) ? n : 1); ++j)
        {
            const scalar phi = 2*pi*j/n;
            normals.append
            (
                vector
                (
                    std::sin(theta)*std::cos(phi),
                    std::sin(theta)*std::sin(phi), std::cos(theta)
                )
            );
        }
    }
    for (label j = 0; !directions.spatial() && j < n; ++j)
    {
        const scalar phi = 2*pi*j/n;
        normals.append(vector(std::cos(phi), std::sin(phi), 0));
    }
    const vectorField normal(normals);
    const nodalVectors x =
        directions.toNodes(vectorField(centre + radius*normal));
    return
        directions.spatial()
      ? surfaceSamples(x, directions.toNodes(normal))
      : surfaceSamples(x);
}


static void checkName
(
    const std::string& what,
    const string& found,
    const string& expected
)
{
    check(what + ", found: " + std::string(found), found != expected, 0);
}


//- What lies in the mesh
static void testContents
(
    const meshBoundary& boundary,
    const solvedDirections& directions
)
{
    const auto contains = [&](const scalar x, const scalar y, const scalar z)
    {
        return boundary.contains(directions(point(x, y, z)));
    };
    check("outside: a point of the liquid", !contains(3.1, 2.2, 1.7), 0);
    check("outside: next to the floor", !contains(7.99, 0.01, 1.7), 0);
    check("outside: next to the baffle", !contains(5.99, 2, 1.7), 0);
    check("outside: between cells", !contains(3.5, 2, 1.5), 0);
    check("inside: a point of the post", contains(1.7, 1.9, 1.7), 0);
    check("inside: a point of the stone", contains(4.01, 2.6, 1.7), 0);
    check("inside: a point above the ceiling", contains(3, 5.01, 1.7), 0);
    check("inside: a point before the inlet", contains(-0.01, 3, 1.7), 0);
    if (directions.spatial())
    {
        check("outside: beside the stone", !contains(4.01, 2.6, 2.1), 0);
        check
        (
            "far beyond the back, in a periodic mesh only",
            contains(3, 3, 17) != directions.images().periods().size(), 0
        );
        check("in the post's image", contains(1.7, 1.9, -0.3), 0);
    }

    nodalVectors points(directions.toNodes(vectorField(4, vector(3, 3, 1))));
    check("none is outside", boundary.firstOutside(points) + 1, 0);
    points.row(2) = directions(point(1.7, 1, 1));
    points.row(3) = directions(point(9, 1, 1));
    check("the third is outside", boundary.firstOutside(points) - 2, 0);
}


//- Which patch is nearest, and how far
static void testDistances
(
    const meshBoundary& boundary,
    const solvedDirections& directions
)
{
    const auto nearest = [&]
    (
        const point& centre,
        const scalar radius,
        const scalar cells
    )
    {
        return boundary.nearest
        (
            ball(directions, centre, radius).points(), cells
        );
    };
    // Beside the stone, 0.518 or 1.036 cell widths from its edge
    const point above(3, 3.5, 1.75);
    const scalar toStone = std::sqrt(1.25) - 0.6;
    checkName
    (
        "nearest, closer than it", nearest(above, 0.6, 2.01*toStone), "stone"
    );
    checkName
    (
        "nearest, closer than a bit less", nearest(above, 0.6, 1.99*toStone), ""
    );
    check
    (
        "distance from walls: the stone",
        boundary.toWalls(ball(directions, above, 0.6).points()) - toStone, 1e-3
    );

    // The floor is nearer, but the outlet has wider cells
    const point corner(7.2, 0.7, 2);
    checkName("nearest in cell widths", nearest(corner, 0.3, 3), "outlet");
    check
    (
        "distance from walls: the floor",
        boundary.toWalls(ball(directions, corner, 0.3).points()) - 0.4, 1e-12
    );
    checkName
    (
        "crosses the baffle", nearest(point(6, 2.6, 2), 0.4, 0.1), "baffle"
    );
    checkName
    (
        "crosses the post", nearest(point(1.8, 0.6, 2), 0.4, 0.1), "post"
    );

    if (directions.images().periods().size())
    {
        const point image(above + vector(0, 0, 8));
        checkName("a period on", nearest(image, 0.6, 2.01*toStone), "stone");
        check
        (
            "distance from walls, a period on",
            boundary.toWalls(ball(directions, image, 0.6).points()) - toStone,
            1e-3
        );
    }
}


//- What is enclosed
static void testEnclosed
(
    const meshBoundary& boundary,
    const solvedDirections& directions
)
{
    const auto enclosed = [&](const point& centre, const scalar radius)
    {
        const surfaceSamples b(ball(directions, centre, radius));
        check("no point is outside", boundary.firstOutside(b.points()) + 1, 0);
        return boundary.enclosed(b);
    };
    checkName
    (
        "encloses the stone", enclosed(point(4.25, 2.75, 1.75), 1), "stone"
    );
    checkName("beside the stone", enclosed(point(3.3, 1.9, 0.9), 0.75), "");
    checkName
    (
        "across the baffle", enclosed(point(6.1, 2.4, 2), 0.77), "baffle"
    );
    if (directions.images().periods().size())
    {
        checkName
        (
            "a period back", enclosed(point(4.25, 2.75, -6.25), 1), "stone"
        );
    }
}


//- Does the line from a to b meet a box?
static bool meets
(
    const boundBox& box,
    const point& a,
    const point& b,
    const solvedDirections& directions
)
{
    scalar from = 0;
    scalar to = 1;
    for (direction d = 0; d < (directions.spatial() ? 3 : 2); ++d)
    {
        const scalar low = (box.min()[d] - a[d])/(b[d] - a[d]);
        const scalar high = (box.max()[d] - a[d])/(b[d] - a[d]);
        from = max(from, min(low, high));
        to = min(to, max(low, high));
    }
    return from <= to;
}


static void testSight(const fvMesh& mesh, const solvedDirections& directions)
{
    DynamicList<lineOfSight::obstacle> all;
    const solvedVector none = 0*directions(vector::one);
    lineOfSight::New(mesh).append
    (
        boundBox(point(-1, -1, -1), point(9, 9, 9)), none, all
    );
    const auto clear = [&](const point& a, const point& b)
    {
        return lineOfSight::clear(all, directions(a), directions(b));
    };

    Random random(1);
    const auto anywhere = [&](const boundBox& box)
    {
        const point x
        (
            box.min() + cmptMultiply(random.sample01<vector>(), box.span())
        );
        return directions.spatial() ? x : point(x.x(), x.y(), 1.75);
    };
    const boundBox regions[] =
    {
        boundBox(point(2.6, 2.1, 0.4), point(5.4, 3.9, 3.6)),
        boundBox(point(5, 0.7, 0.4), point(7, 4.6, 3.6))
    };
    const boundBox bodies[] = {stoneBox, baffleBox};
    label wrong = 0;
    label wrongNear = 0;
    label met = 0;
    for (label i = 0; i < 4000; ++i)
    {
        const point a(anywhere(regions[i % 2]));
        const point b(anywhere(regions[i % 2]));
        const boundBox& body = bodies[i % 2];
        if (i % 2 == 0 && (body.contains(a) || body.contains(b)))
        {
            continue;
        }
        const bool hidden = meets(body, a, b, directions);
        const List<lineOfSight::obstacle> near
        (
            lineOfSight::near(all, directions(a), directions(b - a).norm())
        );
        met += hidden;
        wrong += (clear(a, b) == hidden);
        wrongNear +=
            lineOfSight::clear(near, directions(a), directions(b)) == hidden;
    }
    atLeast("lines that meet the stone or the baffle", met, 400);
    check("lines that meet them unseen, or else", wrong, 0);
    check("the same with the obstacles near", wrongNear, 0);

    // Through common edges and corners of faces and of their triangles, in any
    // direction, and along the edge of the baffle
    label through = 0;
    for (label i = 0; i < 2000; ++i)
    {
        const scalar s = random.sample01<scalar>();
        const point crossed[] =
        {
            point(6, 2, 1 + 2*s), point(6, 1.5 + 2*s, 2), point(6, 2, 2),
            point(6, 2 + 0.5*s, 1.5 + 0.5*s),
            point(6, 2.5 - 0.5*s, 1.5 + 0.5*s),
            point(6, 1.5, 1 + 2*s)
        };
        const point x(crossed[i % 6]);
        const vector d(anywhere(boundBox(-vector::one, vector::one)));
        through += clear(x - 0.37*d, x + 0.41*d);
    }
    check("lines through edges of faces", through, 0);

    if (directions.spatial())
    {
        const auto blocked = [&](const point& a, const point& b)
        {
            return !clear(a, b);
        };
        check
        (
            "in the plane of the baffle, beside it",
            blocked(point(6, 1.4, 0.5), point(6, 1.3, 3.5)), 0
        );
        check
        (
            "in its plane, before a corner",
            blocked(point(6, 1.2, 1.2), point(6, 1.75, 0.6)), 0
        );
        check
        (
            "in its plane, towards it",
            blocked(point(6, 1.1, 2), point(6, 1.4, 2.1)), 0
        );
        check
        (
            "in its plane, through it",
            clear(point(6, 1.4, 0.5), point(6, 3, 3.5)), 0
        );
        check
        (
            "in its plane, inside it",
            clear(point(6, 1.7, 1.6), point(6, 1.8, 1.7)), 0
        );
    }

    // Moved along
    DynamicList<lineOfSight::obstacle> moved;
    lineOfSight::New(mesh).append
    (
        boundBox(point(3.9, 2.4, 0), point(4.6, 3.1, 3)),
        directions(point(10, 0, 0)), moved
    );
    const auto seen = [&](const scalar x)
    {
        return lineOfSight::clear
        (
            moved, directions(point(x, 2, 1.6)), directions(point(x, 4, 1.7))
        );
    };
    check("a stone where it was", !seen(4.2), 0);
    check("none where it is moved to", seen(14.2), 0);
}


static void testClearance
(
    const fvMesh& mesh,
    const solvedDirections& directions
)
{
    const clearance near(mesh, directions);

    // The smallest width is that of the cells at the floor
    const scalar width = gMin(directions.widths(mesh)());
    const surfaceSamples a(ball(directions, point(3, 3.5, 2), 0.4));
    const auto meet = [&]
    (
        const vector& to,
        const scalar radius,
        const scalar cells,
        const bool nested
    )
    {
        const surfaceSamples b(ball(directions, point(3, 3.5, 2) + to, radius));
        return
            near.meet(a, b, cells, nested) + near.meet(b, a, cells, nested);
    };
    check("apart, meet", meet(vector(1, 0, 0), 0.5, 0.099/width, false), 0);
    check
    (
        "near, do not meet", meet(vector(1, 0, 0), 0.5, 0.101/width, false) - 2, 0
    );
    check("crossing, do not meet", meet(vector(0.5, 0, 0), 0.4, 0.5, false) - 2, 0);
    check
    (
        "one inside the other, do not meet",
        meet(vector::zero, 2, 0.1, false) - 2, 0
    );
    check("nested, meet", meet(vector::zero, 2, 0.1, true), 0);
    check
    (
        "nested, yet apart, do not meet",
        meet(vector(1, 0, 0), 0.5, 0.099/width, true) - 2, 0
    );
    check
    (
        "nested, yet crossing, do not meet",
        meet(vector(0.5, 0, 0), 0.4, 0.5, true) - 2, 0
    );
    check
    (
        "beside in the same box, meet", meet(vector(1.1, 1.1, 0), 1.1, 0.1, false), 0
    );

    const auto obstacle = [&]
    (
        const point& centre,
        const scalar radius,
        const scalar cells
    )
    {
        return near.obstacle(ball(directions, centre, radius).points(), cells);
    };
    checkName("nothing near", obstacle(point(3, 3.5, 2), 0.4, 0.5), "");
    checkName
    (
        "beyond the outlet", obstacle(point(12, 3.5, 2), 0.4, 0.5),
        "the boundary"
    );
    checkName
    (
        "next to the ceiling", obstacle(point(3, 4.5, 2), 0.4, 0.5), "ceiling"
    );
    if (directions.images().periods().size())
    {
        checkName
        (
            "longer than the period allows",
            obstacle(point(3, 3.5, 2), 2.1, 0.5),
            "its periodic image (there 8 cell widths)"
        );
        check
        (
            "images apart, meet", meet(vector(0, 0, 7), 0.5, 0.099/width, false), 0
        );
        check
        (
            "images near, do not meet",
            meet(vector(0, 0, 7), 0.5, 0.101/width, false) - 2, 0
        );
        check
        (
            "in an image, do not meet",
            meet(vector(0, 0, 8), 0.2, 0.1, false) - 2, 0
        );
        check
        (
            "nested in an image, meet", meet(vector(0, 0, 8), 0.2, 0.1, true), 0
        );
    }
}


//- Films and spacings, of ellipses or spheroids flattened along the last
//  direction
static void testResolution
(
    const fvMesh& mesh,
    const solvedDirections& directions
)
{
    const clearance near(mesh, directions);
    const scalar width = gMin(directions.widths(mesh)());
    const label d = directions.size();
    autoPtr<surfaceBasis> basis;
    nodalVectors unit;
    if (directions.spatial())
    {
        basis.reset(new sphericalBasis(8, 15));
        unit = directions.toNodes(basis->spherical().grid().nodes());
    }
    else
    {
        basis.reset(new curveBasis(64));
        unit = ball(directions, vector::zero, 1).points();
    }
    const auto flattened = [&](const scalar flatness)
    {
        nodalVectors x(unit);
        x.col(d - 1) *= flatness;
        return closedSurface(*basis, x);
    };

    // Normals of facing nodes make more than 120 degrees, but at the rim
    const scalar b = 0.1;
    scalar thinnest = GREAT;
    for (label i = 0; i < unit.rows(); ++i)
    {
        const scalar z = mag(unit(i, d - 1));
        const scalar slope = z/std::sqrt(max(1 - z*z, SMALL));
        if (slope > b*std::tan(pi/3))
        {
            thinnest = min(thinnest, 2*b*z);
        }
    }
    solvedVector where(d);
    check
    (
        "film of a flat surface, in cell widths",
        near.film(flattened(b), where) - thinnest/width, 1e-9
    );
    check("it is in the middle plane", where(d - 1), 1e-12);
    check
    (
        "film of a round surface, in cell widths",
        near.film(flattened(1), where) - clearance::resolved, 1e-12
    );

    const scalar spacing =
        directions.spatial()
      ? std::sqrt(basis->weights().maxCoeff())
      : 2*std::sin(pi/64);
    check
    (
        "spacing of a round surface, in cell widths",
        near.spacing(flattened(1)) - spacing/width, 1e-9
    );
}


int main(int argc, char* argv[])
{
    argList args(argc, argv);
    Time runTime(Time::controlDictName, args);

    const char* names[] = {"plane", "space", "periodic"};
    for (label i = 0; i < 3; ++i)
    {
        Info<< nl << "In the " << names[i] << " channel" << endl;
        const autoPtr<fvMesh> mesh
        (
            channelMesh(i == 0, i == 2)(runTime, names[i])
        );
        const solvedDirections directions(*mesh);
        check("solved directions", directions.spatial() - (i > 0), 0);

        const meshBoundary& boundary = meshBoundary::New(*mesh);
        testContents(boundary, directions);
        testDistances(boundary, directions);
        testEnclosed(boundary, directions);
        testSight(*mesh, directions);
        testClearance(*mesh, directions);
        testResolution(*mesh, directions);
        check
        (
            "made anew", &boundary != &meshBoundary::New(*mesh), 0
        );
    }
    Info<< nl << "End" << endl;
    return verdict();
}
