/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceViscosity.H"
#include "input.H"

#include <Eigen/Geometry>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- A viscosity of the dictionary [N s/m], zero without the entry
static scalar viscosityOf(const dictionary& dict, const word& entry)
{
    return
        dict.found(entry)
      ? input::getPositive(dict, entry, dimForce*dimTime/dimLength, "N s/m")
      : 0;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::surfaceViscosity::surfaceViscosity(const dictionary& dict)
:
    shear_(viscosityOf(dict, "shear")),
    dilatational_(viscosityOf(dict, "dilatational"))
{
    input::permit(dict, {"shear", "dilatational"});
    if (shear_ == 0 && dilatational_ == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entries shear and dilatational are missing; permitted: either"
            << " or both, or no dictionary surfaceViscosity"
            << exit(FatalIOError);
    }
}


Foam::autoPtr<Foam::capsule::surfaceViscosity>
Foam::capsule::surfaceViscosity::New(const dictionary& dict)
{
    return autoPtr<surfaceViscosity>
    (
        dict.found("surfaceViscosity")
      ? new surfaceViscosity(input::subDict(dict, "surfaceViscosity"))
      : nullptr
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::surfaceViscosity::tensor2
Foam::capsule::surfaceViscosity::stress
(
    const tensor2& inverse,
    const tensor2& history,
    const scalar c
) const
{
    const tensor2 mixed = inverse*history;

    return
        (dilatational_*c - 0.5*across()*mixed.trace())*inverse
      - shear_*mixed*inverse;
}


Foam::capsule::surfaceViscosity::pairDerivative
Foam::capsule::surfaceViscosity::derivative
(
    const surfaceMetric& surface,
    const label node,
    const tensor2& history,
    const scalar c,
    const bool whole
) const
{
    // With y^a = H^ab x_b, the dual tangents x^a and M = h_ab x^a x^b
    //     dA = A x^b.dx_b,        dB = (mu_d - mu_s) y^b.dx_b,
    //     dx^a = -x^b (x^a.dx_b) + a^ab n (n.dx_b),
    //     dy^a = -y^b (x^a.dx_b) - a^ab M.dx_b - x^b (y^a.dx_b)
    //          + H^ab n (n.dx_b).
    typedef surfaceMetric::vectorPair vectorPair;
    typedef Eigen::Matrix<scalar, 3, 3> matrix3;

    const tensor2 a = surface.inverseAt(node);
    const tensor2 H = a*history*a;
    const tensor2 T = stress(a, history, c);
    const scalar B =
        dilatational_*c - 0.5*across()*(a*history).trace();
    const vectorPair tangents = surface.tangentsAt(node);
    const vectorPair x = tangents*a;
    const vectorPair y = tangents*H;
    const vectorPair resultants = tangents*T;
    const matrix3 M = x*history*x.transpose();
    const Eigen::Matrix<scalar, 3, 1> n = surface.normalAt(node);
    const tensor2 turning =
        whole
      ? T
      : surfaceMetric::tensilePart(T, tangents.transpose()*tangents, a);

    // The surface turns in its plane by r = (x^a x n).dx_a/2, at the energy
    // tr T r^2/2
    const scalar compression =
        whole ? 0 : max(-0.5*(resultants.transpose()*tangents).trace(), 0.0);
    const vectorPair twist =
        std::sqrt(0.5*compression)*x.colwise().cross(n);

    pairDerivative result;
    for (label b = 0; b < 2; ++b)
    {
        for (label d = 0; d < 2; ++d)
        {
            result.block<3, 3>(3*b, 3*d) =
                resultants.col(b)*x.col(d).transpose()
              + across()*x.col(b)*y.col(d).transpose()
              - B*x.col(d)*x.col(b).transpose()
              + shear_
               *(
                    y.col(d)*x.col(b).transpose()
                  + x.col(d)*y.col(b).transpose()
                  + a(b, d)*M
                )
              + turning(b, d)*n*n.transpose()
              + twist.col(b)*twist.col(d).transpose();
        }
    }
    return surface.area()(node)*result;
}


// ************************************************************************* //
