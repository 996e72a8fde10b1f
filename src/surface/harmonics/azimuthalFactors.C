/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "azimuthalFactors.H"
#include <complex>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

typedef std::complex<scalar> complexScalar;

//- Without the care for infinities that makes std::complex slow
static inline complexScalar product
(
    const complexScalar& a,
    const complexScalar& b
)
{
    return complexScalar
    (
        a.real()*b.real() - a.imag()*b.imag(),
        a.real()*b.imag() + a.imag()*b.real()
    );
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::azimuthalFactors::setOfValue
(
    const vector& y,
    const vector& e1,
    const vector& e2,
    const label degree
)
{
    const complexScalar direction(y.x(), y.y());
    const complexScalar d1(e1.x(), e1.y());
    const complexScalar d2(e2.x(), e2.y());
    const complexScalar d11 = product(d1, d1);
    const complexScalar d12 = product(d1, d2);
    const complexScalar d22 = product(d2, d2);

    // (x + i y)^m, and its derivatives in x + i y
    complexScalar power(1);
    complexScalar first(0);
    complexScalar second(0);

    for (label m = 0; m <= degree; ++m)
    {
        const complexScalar parts[6] =
        {
            power,
            product(d1, first),
            product(d2, first),
            product(d11, second) - scalar(m)*power,
            product(d12, second),
            product(d22, second) - scalar(m)*power
        };
        for (label j = 0; j < 6; ++j)
        {
            if (m == 0)
            {
                ofValue_(0, j) = parts[j].real();
            }
            else
            {
                ofValue_(2*m - 1, j) = parts[j].real();
                ofValue_(2*m, j) = parts[j].imag();
            }
        }
        second = scalar(m + 1)*first;
        first = scalar(m + 1)*power;
        power = product(power, direction);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::azimuthalFactors::azimuthalFactors
(
    const vector& y,
    const vector& e1,
    const vector& e2,
    const label degree
)
:
    ofValue_(2*degree + 1, 6),
    ofSlope_(2*degree + 1, 6),
    ofCurvature_(2*degree + 1, 6)
{
    setOfValue(y, e1, e2, degree);

    const auto A = ofValue_.col(0);
    const auto A1 = ofValue_.col(1);
    const auto A2 = ofValue_.col(2);

    ofSlope_.col(0).setZero();
    ofSlope_.col(1) = e1.z()*A;
    ofSlope_.col(2) = e2.z()*A;
    ofSlope_.col(3) = 2*e1.z()*A1 - y.z()*A;
    ofSlope_.col(4) = e1.z()*A2 + e2.z()*A1;
    ofSlope_.col(5) = 2*e2.z()*A2 - y.z()*A;

    ofCurvature_.leftCols<3>().setZero();
    ofCurvature_.col(3) = sqr(e1.z())*A;
    ofCurvature_.col(4) = e1.z()*e2.z()*A;
    ofCurvature_.col(5) = sqr(e2.z())*A;
}


// ************************************************************************* //
