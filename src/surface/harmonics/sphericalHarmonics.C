/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphericalHarmonics.H"
#include "error.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Operation>
void Foam::capsule::sphericalHarmonics::forAllDegrees
(
    const scalar z,
    const label degree,
    const Operation& operation
) const
{
    // Zero beyond the functions of a degree, where derivatives need them
    const row zero = row::Zero(2*degree + 3);
    row rows[3] = {zero, zero, zero};
    row slope = zero;
    row curvature = zero;

    rows[0](0) = 1;
    operation(0, rows[0], slope, curvature);

    for (label l = 1; l <= degree; ++l)
    {
        const label start = size(l - 1);
        const label n = 2*l;
        row& Q = rows[l % 3];

        Q.head(n - 1) =
            z*previous_.segment(start, n - 1)*rows[(l + 2) % 3].head(n - 1)
          - beforePrevious_.segment(start, n - 1)
           *rows[(l + 1) % 3].head(n - 1);
        Q.segment(n - 1, 2) = diagonal_(l);

        // dQ_lm/dz is a multiple of Q_l,m+1, two entries on, or one from m = 0
        slope(0) = slope_(start)*Q(1);
        slope.segment(1, n) = slope_.segment(start + 1, n)*Q.segment(3, n);
        curvature(0) = slope_(start)*slope(1);
        curvature.segment(1, n) =
            slope_.segment(start + 1, n)*slope.segment(3, n);

        operation(l, Q, slope, curvature);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::sphericalHarmonics::sphericalHarmonics(const label degree)
:
    degree_(degree),
    diagonal_(degree + 1),
    previous_(size()),
    beforePrevious_(size()),
    slope_(size())
{
    if (degree < 0 || degree > maxDegree)
    {
        FatalErrorInFunction
            << "Degree " << degree << " of spherical harmonics is not in 0 to "
            << maxDegree << exit(FatalError);
    }

    diagonal_(0) = 1;
    for (label m = 1; m <= degree; ++m)
    {
        // Cosine and sine have half the mean square of m = 0
        const scalar ratio = (2*m + 1)/scalar(2*m);
        diagonal_(m) = diagonal_(m - 1)*std::sqrt(m == 1 ? 2*ratio : ratio);
    }

    for (label i = 0; i < size(); ++i)
    {
        const scalar l = degreeOf(i);
        const scalar m = (i - label(l*l) + 1)/2;
        const scalar scale = (2*l + 1)/max((l - m)*(l + m), scalar(1));

        previous_(i) = m < l ? std::sqrt((2*l - 1)*scale) : 0;
        beforePrevious_(i) =
            m < l - 1
          ? std::sqrt((l + m - 1)*(l - m - 1)/(2*l - 3)*scale)
          : 0;
        slope_(i) = std::sqrt((l - m)*(l + m + 1)*(m == 0 ? 0.5 : 1));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::capsule::sphericalHarmonics::degreeOf(const label i)
{
    return label(std::sqrt(scalar(i)));
}


Foam::capsule::nodalScalars Foam::capsule::sphericalHarmonics::values
(
    const vector& y
) const
{
    nodalScalars result(size());
    auto Y = result.array();
    Y(0) = 1;
    scalar cosine = 1;
    scalar sine = 0;

    // The functions obey the recurrence of Q_lm
    for (label l = 1; l <= degree_; ++l)
    {
        const label start = size(l - 1);
        const label n = 2*l - 1;

        Y.segment(start, n) =
            y.z()*previous_.segment(start, n)*Y.segment(size(l - 2), n);
        if (l > 1)
        {
            Y.segment(start, n - 2) -=
                beforePrevious_.segment(start, n - 2)
               *Y.segment(size(l - 3), n - 2);
        }

        const scalar turned = y.x()*cosine - y.y()*sine;
        sine = y.x()*sine + y.y()*cosine;
        cosine = turned;
        Y(start + n) = diagonal_(l)*cosine;
        Y(start + n + 1) = diagonal_(l)*sine;
    }
    return result;
}


Eigen::Matrix<Foam::scalar, Eigen::Dynamic, 6>
Foam::capsule::sphericalHarmonics::expansion
(
    const vector& y,
    const vector& e1,
    const vector& e2
) const
{
    const azimuthalFactors factors(y, e1, e2, degree_);

    Eigen::Matrix<scalar, Eigen::Dynamic, 6> result(size(), 6);
    forAllDegrees
    (
        y.z(),
        degree_,
        [&](const label l, const row& Q, const row& slope, const row& curvature)
        {
            const label n = 2*l + 1;
            for (label j = 0; j < 6; ++j)
            {
                auto column = result.col(j).segment(size(l - 1), n).array();
                const auto value = Q.head(n)*factors.ofValue().col(j).head(n);
                const auto change =
                    slope.head(n)*factors.ofSlope().col(j).head(n);
                if (j == 0)
                {
                    column = value;
                }
                else if (j < 3)
                {
                    column = value + change;
                }
                else
                {
                    column =
                        value + change
                      + curvature.head(n)*factors.ofCurvature().col(j).head(n);
                }
            }
        }
    );
    return result;
}


void Foam::capsule::sphericalHarmonics::expand
(
    const vector& y,
    const vector& e1,
    const vector& e2,
    const nodalVectors& coefficients,
    fieldExpansion& result
) const
{
    const label degree = degreeOf(coefficients.rows()) - 1;
    const label nComponents = coefficients.cols();
    const azimuthalFactors factors(y, e1, e2, degree);

    // Sums over the degrees, a row for each function of the greatest
    typedef Eigen::Array
    <
        scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, maxRow, 3
    > sums;
    sums ofValue = sums::Zero(2*degree + 1, nComponents);
    sums ofSlope = ofValue;
    sums ofCurvature = ofValue;
    forAllDegrees
    (
        y.z(),
        degree,
        [&](const label l, const row& Q, const row& slope, const row& curvature)
        {
            const label n = 2*l + 1;
            for (label k = 0; k < nComponents; ++k)
            {
                const auto part =
                    coefficients.col(k).segment(size(l - 1), n).array();
                ofValue.col(k).head(n) += Q.head(n)*part;
                ofSlope.col(k).head(n) += slope.head(n)*part;
                ofCurvature.col(k).head(n) += curvature.head(n)*part;
            }
        }
    );

    result =
        factors.ofValue().matrix().transpose().lazyProduct(ofValue.matrix());
    result.bottomRows<5>() +=
        factors.ofSlope().rightCols<5>().matrix().transpose().lazyProduct
        (
            ofSlope.matrix()
        );
    result.bottomRows<3>() +=
        factors.ofCurvature().rightCols<3>().matrix().transpose().lazyProduct
        (
            ofCurvature.matrix()
        );
}


void Foam::capsule::sphericalHarmonics::tangents
(
    const vector& y,
    vector& e1,
    vector& e2
)
{
    // Across the axis that is farthest from y
    label axis = 0;
    for (label i = 1; i < vector::nComponents; ++i)
    {
        if (mag(y[i]) < mag(y[axis]))
        {
            axis = i;
        }
    }
    vector across = Zero;
    across[axis] = 1;

    e1 = across ^ y;
    e1 /= mag(e1);
    e2 = y ^ e1;
}


// ************************************************************************* //
