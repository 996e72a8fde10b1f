/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphericalBasis.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sphericalBasis::sphericalBasis
(
    const label degree,
    const label nodeDegree
)
:
    points_(degree),
    fields_(nodeDegree),
    grid_(fields_, nodeDegree, 2)
{
    weights_ = grid_.weights();
    samples_ = sphericalGrid
    (
        sphericalHarmonics(0), max(2*degree, nodeDegree), 0
    ).nodes();
    analysis_ = grid_.analysis();
    for (label i = 0; i < 2; ++i)
    {
        derivative_[i] = grid_.derivative(i)*analysis_;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::capsule::sphericalBasis::spacing() const
{
    return pi/(fields_.degree() + 1);
}


Foam::capsule::nodalMatrix Foam::capsule::sphericalBasis::functions
(
    const UList<surfaceParameter>& at
) const
{
    nodalMatrix f(at.size(), fields_.size());

    forAll(at, i)
    {
        f.row(i) = fields_.values(at[i]).transpose();
    }
    return f;
}


Foam::capsule::nodalFilter Foam::capsule::sphericalBasis::lowPass
(
    const scalar cutoff
) const
{
    nodalScalars factors(fields_.size());

    for (label i = 0; i < factors.size(); ++i)
    {
        factors(i) =
            std::exp(-sqr(pow4(sphericalHarmonics::degreeOf(i)/cutoff)));
    }
    return nodalFilter(grid_.values(), factors, analysis_);
}


Foam::capsule::nodalScalars
Foam::capsule::sphericalBasis::shortestWave() const
{
    const label first = sphericalHarmonics::size(points_.degree() - 1);
    const nodalScalars wave =
        grid_.values().middleCols(first, nPacked() - first).rowwise().sum();
    return wave/wave.cwiseAbs().maxCoeff();
}


Foam::capsule::surfacePoint Foam::capsule::sphericalBasis::expand
(
    const surfaceParameter& at,
    const nodalVectors& coefficients
) const
{
    vector e1, e2;
    sphericalHarmonics::tangents(at, e1, e2);
    sphericalHarmonics::fieldExpansion f;
    points_.expand(at, e1, e2, coefficients, f);

    surfacePoint result;
    result.x = f.row(0);
    for (label i = 0; i < 2; ++i)
    {
        result.first[i] = f.row(1 + i);
    }
    for (label i = 0; i < 3; ++i)
    {
        result.second[i] = f.row(3 + i);
    }
    return result;
}


Foam::capsule::surfaceParameter Foam::capsule::sphericalBasis::moved
(
    const surfaceParameter& from,
    const scalar (&step)[2]
) const
{
    vector e1, e2;
    sphericalHarmonics::tangents(from, e1, e2);
    return normalised(from + step[0]*e1 + step[1]*e2);
}


Foam::capsule::nodalScalars Foam::capsule::sphericalBasis::pack
(
    const nodalVectors& v
) const
{
    return
        std::sqrt(scalar(nPacked()))
       *stacked(nodalVectors(analysis_.topRows(nPacked())*v));
}


Foam::capsule::nodalVectors Foam::capsule::sphericalBasis::unpack
(
    const nodalScalars& v
) const
{
    return
        grid_.values().leftCols(nPacked())
       *(unstacked(v, 3)/std::sqrt(scalar(nPacked())));
}


Foam::capsule::nodalScalars Foam::capsule::sphericalBasis::packedWeights
(
    const nodalVectors& weights
) const
{
    return stacked
    (
        nodalVectors
        (
            grid_.values().leftCols(nPacked()).transpose()*weights
        )
    )/std::sqrt(scalar(nPacked()));
}


Foam::capsule::nodalMatrix Foam::capsule::sphericalBasis::reduced
(
    const nodalFilter& filter,
    const label
) const
{
    // The filter gives back each harmonic times its factor
    const label n = nPacked();
    const nodalScalars factors =
        filter.analysis().topRows(n)
       .cwiseProduct(grid_.values().leftCols(n).transpose()).rowwise().sum();
    return nodalMatrix(factors.asDiagonal());
}


Foam::capsule::nodalMatrix Foam::capsule::sphericalBasis::multiplied
(
    const nodalScalars& factor,
    const nodalMatrix& rows
) const
{
    const label n = nPacked();
    if (rows.cols() < n)
    {
        const nodalMatrix nodal = grid_.values().leftCols(n)*rows;
        return analysis_.topRows(n)*(factor.asDiagonal()*nodal);
    }

    // Fewer products by way of the factor's own matrix
    const nodalMatrix scaledValues =
        factor.asDiagonal()*grid_.values().leftCols(n);
    const nodalMatrix ofFactor = analysis_.topRows(n)*scaledValues;
    return ofFactor*rows;
}


Foam::capsule::nodalVectors Foam::capsule::sphericalBasis::symmetric
(
    const nodalVectors& x
) const
{
    return unpack(pack(x));
}


// ************************************************************************* //
