/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-coupledFactors

Description
    Unit tests of the order of nested dissection and of the factors of a coupled
    matrix, on grids of squares with collocated velocity and pressure: each
    unknown once, residuals of solutions, and fewer entries than in Eigen's own
    order, in a narrow channel as many, whatever the units. Ends with an error
    if any fails.

\*---------------------------------------------------------------------------*/

#include "coupledFactors.H"
#include "nestedDissection.H"
#include "judgement.H"
#include "DynamicList.H"
#include <algorithm>
#include <vector>

using namespace Foam;
using namespace Foam::capsule;

typedef Eigen::SparseMatrix<scalar> sparse;

//- A grid of nx by ny squares of the side h
struct grid
{
    const label nx;
    const label ny;
    const scalar h;

    nodalVectors centres() const
    {
        nodalVectors x(nx*ny, 2);
        for (label celli = 0; celli < nx*ny; ++celli)
        {
            x.row(celli) << (celli % nx + 0.5)*h, (celli/nx + 0.5)*h;
        }
        return x;
    }

    //- The cell beside one along an axis, or none: -1
    label beside(const label celli, const label axis, const label sense) const
    {
        const label i = celli % nx + (axis == 0 ? sense : 0);
        const label j = celli/nx + (axis == 1 ? sense : 0);
        return i < 0 || j < 0 || i >= nx || j >= ny ? -1 : j*nx + i;
    }

    labelListList neighbours() const
    {
        labelListList result(nx*ny);
        forAll(result, celli)
        {
            DynamicList<label> list;
            for (const label axis : {0, 1})
            {
                for (const label sense : {-1, 1})
                {
                    const label other = beside(celli, axis, sense);
                    if (other != -1)
                    {
                        list.append(other);
                    }
                }
            }
            result[celli].transfer(list);
        }
        return result;
    }
};


//- Stokes flow between walls, kinematic viscosity nu: momentum, and continuity
//  with Rhie-Chow interpolation; the pressure of cell 0 is given
static sparse stokes(const grid& cells, const scalar nu)
{
    const label n = cells.nx*cells.ny;
    const scalar h = cells.h;
    const scalar rAU = sqr(h)/(4*nu);
    std::vector<Eigen::Triplet<scalar>> entries;
    const auto add = [&](const label row, const label column, const scalar a)
    {
        if (row != 2)
        {
            entries.emplace_back(row, column, a);
        }
    };

    for (label c = 0; c < n; ++c)
    {
        for (const label axis : {0, 1})
        {
            for (const label sense : {-1, 1})
            {
                const label o = cells.beside(c, axis, sense);
                const scalar half = sense/(2*h);
                const label at = o == -1 ? c : o;
                for (const label i : {0, 1})
                {
                    add(3*c + i, 3*c + i, (o == -1 ? 2 : 1)*nu/sqr(h));
                    if (o != -1)
                    {
                        add(3*c + i, 3*o + i, -nu/sqr(h));
                    }
                }
                add(3*c + axis, 3*c + 2, half);
                add(3*c + axis, 3*at + 2, half);
                if (o == -1)
                {
                    continue;
                }
                add(3*c + 2, 3*c + axis, half);
                add(3*c + 2, 3*o + axis, half);
                add(3*c + 2, 3*c + 2, rAU/sqr(h));
                add(3*c + 2, 3*o + 2, -rAU/sqr(h));
                for (const label from : {c, o})
                {
                    for (const label turn : {-1, 1})
                    {
                        const label to = cells.beside(from, axis, turn);
                        const scalar a = rAU*half*turn/(2*h);
                        add(3*c + 2, 3*from + 2, a);
                        add(3*c + 2, 3*(to == -1 ? from : to) + 2, a);
                    }
                }
            }
        }
    }
    entries.emplace_back(2, 2, 1/nu);

    sparse result(3*n, 3*n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}


static void testOrder(const grid& cells)
{
    const nodalVectors centres(cells.centres());
    const labelListList neighbours(cells.neighbours());
    const nestedDissection dissection(centres, neighbours);

    labelList times(3*centres.rows(), 0);
    for (const label i : dissection.order())
    {
        ++times[i];
    }
    check
    (
        "unknowns of " + std::to_string(cells.nx) + " x "
      + std::to_string(cells.ny) + " cells that are not in the order once",
        std::count_if
        (
            times.begin(), times.end(), [](const label k) { return k != 1; }
        ),
        0
    );
}


//- Solutions, and entries of the factors over those in Eigen's own order
static void testFactors
(
    const grid& cells,
    const scalar nu,
    const scalar bound
)
{
    const std::string of =
        ", " + std::to_string(cells.nx) + " x " + std::to_string(cells.ny)
      + " cells, nu/h " + Foam::name(nu/cells.h);
    const sparse matrix(stokes(cells, nu));
    const nodalScalars x = nodalScalars::Random(matrix.rows());

    coupledFactors factors(cells.centres());
    factors.compute(matrix);
    const nodalScalars found = factors.solve(matrix*x);
    check
    (
        "residual" + of, (matrix*(found - x)).norm()/(matrix*x).norm(), 1e-11
    );

    const scalar s = nu/cells.h;
    nodalScalars scale = nodalScalars::Ones(matrix.rows());
    for (Eigen::Index i = 2; i < scale.size(); i += 3)
    {
        scale(i) = s;
    }
    const sparse scaled = scale.asDiagonal()*matrix*scale.asDiagonal();
    Eigen::SparseLU<sparse> own;
    own.compute(scaled);
    check
    (
        "entries over those in Eigen's own order" + of,
        factors.entries()/scalar(own.nnzL() + own.nnzU()),
        bound
    );
}


int main()
{
    for (const grid& cells : {grid{1, 1, 1}, grid{7, 5, 1}, grid{60, 3, 0.1}})
    {
        testOrder(cells);
    }
    for (const scalar nu : {1e-6, 1.0, 1e6})
    {
        testFactors(grid{96, 96, 0.01}, nu, 0.75);
        testFactors(grid{160, 16, 2.5e-7}, nu, 1.1);
    }
    return nFailed() > 0;
}


// ************************************************************************* //
