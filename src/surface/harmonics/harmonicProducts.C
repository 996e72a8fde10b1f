/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "harmonicProducts.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::capsule::nodalMatrix>
Foam::capsule::harmonicProducts::transform
(
    const nodalMatrix& fields,
    const nodalMatrix& waves
)
{
    const label nAround = waves.rows();

    List<nodalMatrix> result(fields.cols());
    forAll(result, i)
    {
        const Eigen::Map<const nodalMatrix> byCircles
        (
            fields.col(i).data(), nAround, fields.rows()/nAround
        );
        result[i] = byCircles.transpose()*waves;
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::harmonicProducts::around
(
    const nodalMatrix& cosinePart,
    const nodalMatrix& sinePart,
    const label m,
    const bool sine,
    const bool differentiated,
    const label m2,
    const bool sine2,
    const bool differentiated2
)
{
    // (cos)' = -m sin, (sin)' = m cos, m being with the function of theta
    const scalar sign =
        ((differentiated && !sine) != (differentiated2 && !sine2)) ? -0.5 : 0.5;
    const bool s = (sine != differentiated);
    const bool s2 = (sine2 != differentiated2);
    const label sum = m + m2;
    const label difference = mag(m - m2);

    if (s == s2)
    {
        return
            sign*cosinePart.col(difference)
          + (s ? -sign : sign)*cosinePart.col(sum);
    }
    return
        sign*sinePart.col(sum)
      + ((m > m2) == s ? sign : -sign)*sinePart.col(difference);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::harmonicProducts::harmonicProducts
(
    const sphericalGrid& grid,
    const label degree,
    const label nDerivatives
)
:
    degree_(degree),
    nDerivatives_(nDerivatives),
    nCircles_(grid.degree() + 1),
    alongTheta_(degree + 1),
    cosines_(grid.size()/nCircles_, 2*degree + 1),
    sines_(cosines_.rows(), cosines_.cols())
{
    const label nAround = cosines_.rows();
    for (label i = 0; i < nAround; ++i)
    {
        for (label M = 0; M <= 2*degree; ++M)
        {
            const scalar angle = 2*pi*((i*M) % nAround)/nAround;
            cosines_(i, M) = std::cos(angle);
            sines_(i, M) = std::sin(angle);
        }
    }

    // At phi = 0, the first node of each circle, the cosine is 1, and so is
    // the sine's derivative over m
    for (label m = 0; m <= degree; ++m)
    {
        nodalMatrix& part = alongTheta_[m];
        part = nodalMatrix::Zero(nDerivatives*nCircles_, degree + 1 - m);
        for (label a = 0; a < nDerivatives; ++a)
        {
            const nodalMatrix& d =
                a < 2
              ? grid.derivative(a)
              : grid.secondDerivative((a - 2)/2, (a - 1)/2);

            for (label l = m; l <= degree && (m || !odd(a)); ++l)
            {
                for (label circle = 0; circle < nCircles_; ++circle)
                {
                    part(a*nCircles_ + circle, l - m) =
                        d(circle*nAround, index(l, m, odd(a)));
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::harmonicProducts::product
(
    const nodalMatrix& fields
) const
{
    const List<nodalMatrix> cosineParts(transform(fields, cosines_));
    const List<nodalMatrix> sineParts(transform(fields, sines_));

    const label n = sphericalHarmonics::size(degree_);
    nodalMatrix result(n, n);
    nodalMatrix weighted;

    for (label m = 0; m <= degree_; ++m)
    {
        for (label m2 = 0; m2 <= degree_; ++m2)
        {
            const nodalMatrix& part2 = alongTheta_[m2];
            for (label sines = 0; sines < 4; ++sines)
            {
                const bool sine = sines/2;
                const bool sine2 = sines % 2;
                if ((sine && !m) || (sine2 && !m2))
                {
                    continue;
                }
                weighted.setZero(part2.rows(), part2.cols());
                for (label a = 0; a < nDerivatives_; ++a)
                {
                    for (label b = 0; b < nDerivatives_; ++b)
                    {
                        const label i = a*nDerivatives_ + b;
                        weighted.middleRows(a*nCircles_, nCircles_) +=
                            around
                            (
                                cosineParts[i], sineParts[i],
                                m, sine, odd(a), m2, sine2, odd(b)
                            ).asDiagonal()
                           *part2.middleRows(b*nCircles_, nCircles_);
                    }
                }
                const nodalMatrix block =
                    alongTheta_[m].transpose()*weighted;

                for (label l = m; l <= degree_; ++l)
                {
                    for (label l2 = m2; l2 <= degree_; ++l2)
                    {
                        result(index(l, m, sine), index(l2, m2, sine2)) =
                            block(l - m, l2 - m2);
                    }
                }
            }
        }
    }
    return result;
}


// ************************************************************************* //
