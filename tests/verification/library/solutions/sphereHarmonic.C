/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sphereHarmonic.H"
#include "addToRunTimeSelectionTable.H"
#include <complex>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace analyticalSolutions
{
    defineTypeNameAndDebug(sphereHarmonic, 0);
    addToRunTimeSelectionTable(analyticalSolution, sphereHarmonic, dictionary);

    // In space the solved directions are x, y and z
    static vector toVector(const solvedVector& v)
    {
        return vector(v(0), v(1), v(2));
    }

    static Eigen::RowVector3d toRow(const vector& v)
    {
        return Eigen::RowVector3d(v.x(), v.y(), v.z());
    }
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::capsule::analyticalSolutions::sphereHarmonic::legendre
(
    const scalar z,
    const label k
) const
{
    // The k-th derivative of P_k is 1 3 5 ... (2 k - 1), and
    // (i - k) P_i = (2 i - 1) z P_i-1 - (i + k - 1) P_i-2 of the derivatives
    scalar before = 0;
    scalar now = (k <= l_ ? 1 : 0);
    for (label i = 1; i <= k; ++i)
    {
        now *= 2*i - 1;
    }
    for (label i = k + 1; i <= l_; ++i)
    {
        const scalar next =
            ((2*i - 1)*z*now - (i + k - 1)*before)/(i - k);
        before = now;
        now = next;
    }
    return now;
}


Foam::scalar Foam::capsule::analyticalSolutions::sphereHarmonic::harmonic
(
    const vector& n,
    vector& gradient
) const
{
    const vector y = frame_ & n;
    const std::complex<scalar> w(y.x(), y.y());
    const std::complex<scalar> around = std::pow(w, m_);
    const std::complex<scalar> slope =
        (m_ == 0 ? 0 : scalar(m_)*std::pow(w, m_ - 1));
    const scalar P = legendre(y.z(), m_);

    const vector inSpace
    (
        slope.real()*P,
       -slope.imag()*P,
        around.real()*legendre(y.z(), m_ + 1)
    );
    gradient = scale_*(frame_.T() & (inSpace - (inSpace & y)*y));
    return scale_*around.real()*P;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::analyticalSolutions::sphereHarmonic::sphereHarmonic
(
    const dictionary& dict,
    const solvedDirections& directions,
    const Pair<scalar>& viscosity,
    const scalar density
)
:
    analyticalSolution(dict, directions, viscosity, density),
    l_(dict.getCheck<label>("degree", labelMinMax::ge(0))),
    m_(dict.getCheck<label>("order", labelMinMax(0, l_))),
    frame_(tensor::I),
    scale_(0),
    flow_
    (
        l_,
        radius_,
        viscosity,
        {
            dict.get<scalar>("normal"),
            dict.get<scalar>("tangential"),
            dict.get<scalar>("swirl")
        }
    )
{
    if (!directions.spatial())
    {
        FatalIOErrorInFunction(dict)
            << "Entry type: " << typeName << " needs a mesh without empty and"
            << " wedge patches" << exit(FatalIOError);
    }

    const vector z = normalised(dict.get<vector>("axis"));
    const vector towards = dict.get<vector>("meridian");
    const vector x = normalised(towards - (towards & z)*z);
    frame_ = tensor(x, z ^ x, z);

    // (2 - delta_m0) (2 l + 1) (l - m)!/(l + m)!
    scalar square = (m_ == 0 ? 1 : 2)*(2*l_ + 1);
    for (label i = l_ - m_ + 1; i <= l_ + m_; ++i)
    {
        square /= i;
    }
    scale_ = Foam::sqrt(square);
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::capsule::analyticalSolution::localFlow
Foam::capsule::analyticalSolutions::sphereHarmonic::relativeFlow
(
    const solvedVector& d,
    const scalar,
    const bool in
) const
{
    // The flow at the centre is that just beside it
    const vector x = toVector(d) + vector(SMALL*radius_, 0, 0);
    const vector n = x/mag(x);
    vector slope;
    const scalar Y = harmonic(n, slope);
    const sphereFlow::factors at = flow_(mag(x), in);
    return
    {
        toRow(at.U*Y*n + at.V*slope + at.W*(n ^ slope)),
        at.p*Y
    };
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::nodalVectors
Foam::capsule::analyticalSolutions::sphereHarmonic::force
(
    const closedSurface& surface,
    const scalar t
) const
{
    const sphereFlow::amplitudes& f = flow_.force();
    nodalVectors result(surface.size(), 3);
    for (label i = 0; i < surface.size(); ++i)
    {
        const vector n = normalised
        (
            toVector(relative(surface.nodes().row(i), t))
        );
        vector slope;
        const scalar Y = harmonic(n, slope);
        result.row(i) = toRow
        (
            f.normal*Y*n + f.tangential*slope + f.swirl*(n ^ slope)
        );
    }
    return result;
}
