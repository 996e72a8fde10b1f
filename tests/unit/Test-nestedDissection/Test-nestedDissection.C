/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

Application
    Test-nestedDissection

Description
    Unit tests of the order of unknowns of the direct flow solver, on a square
    of cells with the couplings of Stokes flow: velocities with those of
    neighbours and the pressure, pressures with those of neighbours' neighbours
    as well. The order has each unknown once, also of a channel that is much
    longer than wide, of one row and of a few cells; its factors fill less than
    those of Eigen's own order, and solve as well. Returns the number of
    failures.

\*---------------------------------------------------------------------------*/

#include "judgement.H"
#include "nestedDissection.H"
#include <Eigen/SparseLU>
#include <algorithm>
#include <vector>

using namespace Foam;
using namespace Foam::capsule;

typedef Eigen::SparseMatrix<scalar> sparseMatrix;

//- Cells of width 1 in n columns and m rows
struct grid
{
    nodalVectors centres;
    labelListList neighbours;

    grid(const label n, const label m)
    :
        centres(n*m, 2),
        neighbours(n*m)
    {
        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j < m; ++j)
            {
                const label celli = i*m + j;
                centres.row(celli) << i + 0.5, j + 0.5;
                DynamicList<label> beside;
                if (i > 0) { beside.append(celli - m); }
                if (i < n - 1) { beside.append(celli + m); }
                if (j > 0) { beside.append(celli - 1); }
                if (j < m - 1) { beside.append(celli + 1); }
                neighbours[celli].transfer(beside);
            }
        }
    }
};


//- Is each unknown there once?
static void testPermutation(const label n, const label m)
{
    const grid cells(n, m);
    const nestedDissection dissection(cells.centres, cells.neighbours);
    std::vector<label> order
    (
        dissection.order().begin(), dissection.order().end()
    );
    std::sort(order.begin(), order.end());
    label wrong = mag(label(order.size()) - 3*n*m);
    for (label i = 0; i < label(order.size()); ++i)
    {
        wrong += (order[i] != i);
    }
    check
    (
        "unknowns that are missing or twice, " + std::to_string(n) + " x "
      + std::to_string(m), wrong, 0
    );
}


//- Stokes flow with walls, and Rhie and Chow's interpolation: the pressure's
//  laplacian of neighbours less that of neighbours' neighbours; a small part of
//  the pressure itself fixes its level
static sparseMatrix stokes(const grid& cells)
{
    const label nCells = cells.neighbours.size();
    std::vector<Eigen::Triplet<scalar>> entries;
    sparseMatrix laplacian(nCells, nCells);
    sparseMatrix gradient[2];
    for (direction d = 0; d < 2; ++d)
    {
        std::vector<Eigen::Triplet<scalar>> slopes;
        for (label c = 0; c < nCells; ++c)
        {
            for (const label other : cells.neighbours[c])
            {
                const scalar side = cells.centres(other, d) - cells.centres(c, d);
                slopes.emplace_back(c, other, 0.5*side);
                slopes.emplace_back(c, c, 0.5*side);
            }
        }
        gradient[d].resize(nCells, nCells);
        gradient[d].setFromTriplets(slopes.begin(), slopes.end());
    }
    for (label c = 0; c < nCells; ++c)
    {
        for (const label other : cells.neighbours[c])
        {
            entries.emplace_back(c, other, 1);
            entries.emplace_back(c, c, -1);
        }
    }
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const sparseMatrix wide =
        gradient[0]*gradient[0] + gradient[1]*gradient[1];
    const sparseMatrix pressure = 0.25*(wide - laplacian);

    entries.clear();
    const auto add = [&](const sparseMatrix& m, const label row, const label col)
    {
        for (label k = 0; k < m.outerSize(); ++k)
        {
            for (sparseMatrix::InnerIterator it(m, k); it; ++it)
            {
                entries.emplace_back
                (
                    3*it.row() + row, 3*it.col() + col, it.value()
                );
            }
        }
    };
    for (label d = 0; d < 2; ++d)
    {
        add(-laplacian, d, d);
        add(gradient[d], d, 2);
        add(gradient[d], 2, d);
        for (label c = 0; c < nCells; ++c)
        {
            // Walls
            entries.emplace_back
            (
                3*c + d, 3*c + d, 2*(4 - cells.neighbours[c].size())
            );
        }
    }
    add(pressure, 2, 2);
    for (label c = 0; c < nCells; ++c)
    {
        entries.emplace_back(3*c + 2, 3*c + 2, 1e-3);
    }
    sparseMatrix result(3*nCells, 3*nCells);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}


//- Entries of the factors of a matrix, and the error of a solution of ones
template<class Factors>
static Pair<scalar> factorised(Factors& factors, const sparseMatrix& matrix)
{
    factors.compute(matrix);
    const nodalScalars ones = nodalScalars::Ones(matrix.rows());
    const nodalScalars x = factors.solve(matrix*ones);
    return Pair<scalar>
    (
        scalar(factors.nnzL()) + scalar(factors.nnzU()),
        (x - ones).cwiseAbs().maxCoeff()
    );
}


static void testFill(const label n, const scalar bound)
{
    const grid cells(n, n);
    const sparseMatrix matrix = stokes(cells);

    Eigen::SparseLU<sparseMatrix> byColumns;
    const Pair<scalar> usual(factorised(byColumns, matrix));

    const nestedDissection dissection(cells.centres, cells.neighbours);
    Eigen::PermutationMatrix<Eigen::Dynamic> order(matrix.rows());
    forAll(dissection.order(), i)
    {
        order.indices()(dissection.order()[i]) = i;
    }
    sparseMatrix ordered;
    ordered = matrix.twistedBy(order);
    Eigen::SparseLU<sparseMatrix, Eigen::NaturalOrdering<int>> factors;
    // As in directFlowSolver
    factors.setPivotThreshold(0.01);
    const Pair<scalar> dissected(factorised(factors, ordered));

    const std::string of = ", " + std::to_string(n) + " cells a side";
    check
    (
        "entries of the factors over those by columns" + of,
        dissected.first()/usual.first(), bound
    );
    check("error of the solution" + of, dissected.second(), 1e-9);
}


int main()
{
    testPermutation(1, 1);
    testPermutation(3, 2);
    testPermutation(64, 1);
    testPermutation(33, 20);
    testPermutation(128, 5);
    testFill(40, 0.9);
    testFill(120, 0.75);
    return nFailed();
}


// ************************************************************************* //
