/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceResponse.H"
#include "polarRule.H"
#include "sphericalGrid.H"
#include "PtrList.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Fields at the points of a polarRule
typedef Eigen::Array<scalar, Eigen::Dynamic, 1> ruleScalars;
typedef Eigen::Array<scalar, Eigen::Dynamic, 3> ruleVectors;

//- The different components of a symmetric tensor
static const label nComponents = 6;
static const label firstIndex[nComponents] = {0, 0, 0, 1, 1, 2};
static const label secondIndex[nComponents] = {0, 1, 2, 1, 2, 2};

//- What depends on the degree alone
struct responseRules
{
    //- Nodes of products of fields, of the velocity, and a circle of these
    const sphericalGrid products;
    const sphericalGrid nodes;
    const nodalMatrix analysis;
    const nodalMatrix waves;
    const polarRule polar;

    explicit responseRules(const sphericalHarmonics& harmonics)
    :
        products(harmonics, 2*harmonics.degree(), 1),
        nodes(harmonics, harmonics.degree(), 1),
        analysis(nodes.analysis()),
        waves
        (
            polarRule::waves(harmonics.degree(), 2*harmonics.degree() + 2)
        ),
        polar(harmonics)
    {}

    //- Those of the degree, kept for the run: they take a third of a response
    static const responseRules& of(const sphericalHarmonics& harmonics)
    {
        static PtrList<responseRules> known(sphericalHarmonics::maxDegree + 1);
        const label degree = harmonics.degree();
        if (!known.set(degree))
        {
            known.set(degree, new responseRules(harmonics));
        }
        return known[degree];
    }
};


//- Area per area of the parameter sphere and unit normal at the nodes
static nodalScalars areaElement
(
    const sphericalGrid& grid,
    const nodalVectors& X,
    nodalVectors& normal
)
{
    const nodalVectors a = grid.derivative(0)*X;
    const nodalVectors b = grid.derivative(1)*X;
    normal.resize(grid.size(), 3);
    for (label i = 0; i < 3; ++i)
    {
        const label j = (i + 1) % 3;
        const label k = (i + 2) % 3;
        normal.col(i) =
            a.col(j).cwiseProduct(b.col(k)) - a.col(k).cwiseProduct(b.col(j));
    }
    const nodalScalars area = normal.rowwise().norm();
    normal.array().colwise() /= area.array();
    return area;
}


//- The inner product of fields that is the integral over the surface
struct surfaceProduct
{
    //- M of the header
    nodalMatrix matrix;

    //- The packed normal, and M times it
    nodalScalars normal;
    nodalScalars normalArea;

    surfaceProduct(const sphericalGrid& grid, const nodalVectors& X)
    {
        nodalVectors normals;
        const nodalScalars area = areaElement(grid, X, normals);

        const nodalMatrix half =
            (area.cwiseProduct(grid.weights())/(4*pi)).cwiseSqrt().asDiagonal()
           *grid.values();
        matrix.setZero(X.rows(), X.rows());
        matrix.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
        matrix.triangularView<Eigen::StrictlyUpper>() = matrix.transpose();

        const nodalVectors packed = grid.analysis()*normals;
        normal = stacked(packed);
        normalArea = applied(normal);
    }

    //- M times a packed field
    nodalScalars applied(const nodalScalars& field) const
    {
        const label n = matrix.rows();
        nodalScalars result(3*n);
        for (label a = 0; a < 3; ++a)
        {
            result.segment(a*n, n) = matrix*field.segment(a*n, n);
        }
        return result;
    }
};


//- The packed matrix per area of the surface, from blocks per area of the
//  parameter sphere: one for each component of the kernel, transposed, stacked
static nodalMatrix perArea
(
    const nodalMatrix& blocks,
    const surfaceProduct& product
)
{
    const label n = blocks.cols();
    nodalMatrix result(3*n, 3*n);
    for (label c = 0; c < nComponents; ++c)
    {
        const label a = firstIndex[c]*n;
        const label b = secondIndex[c]*n;
        result.block(a, b, n, n).noalias() =
            blocks.middleRows(c*n, n).transpose()*product.matrix;
        if (a != b)
        {
            result.block(b, a, n, n) = result.block(a, b, n, n);
        }
    }
    return result;
}


//- Integrals of a kernel times each harmonic for the nodes x of a circle, given
//  the coefficients of the surface turned for each of them (columns: nodes;
//  rows: harmonics, for one component of the kernel after the other)
template<class Kernel>
static nodalMatrix circleIntegrals
(
    const polarRule& rule,
    const nodalMatrix& turned,
    const nodalVectors& x,
    const Kernel& kernel
)
{
    const label around = x.rows();
    const nodalMatrix points = rule.values(turned);

    nodalMatrix kernels(rule.size(), nComponents*around);
    ruleVectors r(rule.size(), 3);
    ruleScalars diagonal, dyad;
    for (label k = 0; k < around; ++k)
    {
        for (label a = 0; a < 3; ++a)
        {
            r.col(a) = x(k, a) - points.col(3*k + a).array();
        }
        kernel(k, r, diagonal, dyad);
        diagonal *= rule.weights().array();
        dyad *= rule.weights().array();
        for (label c = 0; c < nComponents; ++c)
        {
            const label a = firstIndex[c];
            const label b = secondIndex[c];
            auto component = kernels.col(nComponents*k + c).array();
            component = dyad*r.col(a)*r.col(b);
            if (a == b)
            {
                component += diagonal;
            }
        }
    }

    const nodalMatrix sums = rule.sums(kernels);
    nodalMatrix result(nComponents*sums.rows(), around);
    for (label k = 0; k < around; ++k)
    {
        const nodalMatrix back = polarRule::turned
        (
            sums.middleCols(nComponents*k, nComponents), -2*pi*k/around
        );
        result.col(k) =
            Eigen::Map<const nodalScalars>(back.data(), back.size());
    }
    return result;
}


//- Response to forces per area of the parameter sphere, in the blocks of
//  perArea(), by a kernel a I + b r r that is given the node and all r of its
//  rule
template<class Kernel>
static nodalMatrix response
(
    const responseRules& rules,
    const nodalVectors& X,
    const Kernel& kernel
)
{
    const sphericalGrid& grid = rules.nodes;
    const label n = X.rows();
    const label around = rules.waves.rows();
    const nodalVectors x = grid.values()*X;
    polarRule rule(rules.polar);

    // Each node of a circle in turn at phi = 0
    nodalMatrix turned(n, 3*around);
    for (label k = 0; k < around; ++k)
    {
        turned.middleCols(3*k, 3) = polarRule::turned(X, 2*pi*k/around);
    }

    nodalMatrix result = nodalMatrix::Zero(nComponents*n, n);
    for (label first = 0; first < grid.size(); first += around)
    {
        rule.setPole(std::acos(grid.nodes()[first].z()));
        const auto ofCircle =
            [&](label k, const ruleVectors& r, ruleScalars& a, ruleScalars& b)
        {
            kernel(first + k, r, a, b);
        };
        const nodalMatrix sums =
            circleIntegrals(rule, turned, x.middleRows(first, around), ofCircle)
           *rules.waves;

        // The factor of a harmonic that depends on theta is the cosine's value
        // at phi = 0
        for (label i = 0; i < n; ++i)
        {
            const label l = sphericalHarmonics::degreeOf(i);
            const label entry = i - l*l;
            const label cosine = entry == 0 ? i : i - (entry + 1) % 2;
            result.col(i) += rules.analysis(cosine, first)*sums.col(entry);
        }
    }
    return result;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::surfaceResponse::singleLayer
(
    const sphericalHarmonics& harmonics,
    const nodalVectors& X,
    const scalar mu
)
{
    const auto kernel =
        [](const label, const ruleVectors& r, ruleScalars& a, ruleScalars& b)
    {
        const ruleScalars r2 = r.square().rowwise().sum();
        a = r2.sqrt().inverse();
        b = a/r2;
    };
    const responseRules& rules = responseRules::of(harmonics);
    nodalMatrix blocks = response(rules, X, kernel)/(8*pi*mu);
    const label n = harmonics.size();
    for (label c = 0; c < nComponents; ++c)
    {
        auto block = blocks.middleRows(c*n, n);
        block = (0.5*(block + block.transpose())).eval();
    }
    const surfaceProduct product(rules.products, X);
    nodalMatrix S = perArea(blocks, product);

    // Per area of the parameter sphere the uniform pressure is M n: it is taken
    // out on both sides
    const scalar scale = 1/product.normalArea.squaredNorm();
    const nodalScalars motion = scale*S*product.normal;
    S -= motion*product.applied(product.normalArea).transpose();
    const nodalScalars flux = scale*S.transpose()*product.normalArea;
    S -= product.normalArea*flux.transpose();
    return S;
}


Foam::capsule::nodalMatrix Foam::capsule::surfaceResponse::adjointDoubleLayer
(
    const sphericalHarmonics& harmonics,
    const nodalVectors& X
)
{
    const responseRules& rules = responseRules::of(harmonics);
    nodalVectors normal;
    areaElement(rules.nodes, X, normal);
    const auto kernel =
        [&](const label i, const ruleVectors& r, ruleScalars& a, ruleScalars& b)
    {
        const ruleScalars r2 = r.square().rowwise().sum();
        const ruleScalars rn = r.matrix()*normal.row(i).transpose();
        a.setZero(r.rows());
        b = rn/(r2.square()*r2.sqrt());
    };
    const surfaceProduct product(rules.products, X);
    nodalMatrix K = perArea(response(rules, X, kernel)*(-3/(4*pi)), product);

    // K n = n/2
    const nodalScalars defect = 0.5*product.normal - K*product.normal;
    K +=
        defect*product.normalArea.transpose()
       /product.normalArea.dot(product.normal);
    return K;
}


// ************************************************************************* //
