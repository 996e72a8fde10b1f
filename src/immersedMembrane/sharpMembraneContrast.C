/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "sharpMembrane.H"
#include "freeSpaceResponse.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalMatrix Foam::capsule::sharpMembrane::fluidDerivative
(
    const couplingMethod& method
)
{
    const label n = basis().nPacked();
    nodalMatrix derivative = nodalMatrix::Identity(2*n, 2*n);

    if (ratio_ != 1)
    {
        traction_ = freeSpaceResponse::adjointDoubleLayer(curve());
        traction_.diagonal().array() += 0.5;
        if (!method.usesResponse())
        {
            return 0.5*(1 + ratio_)*derivative;
        }
        derivative -= (1 - ratio_)*traction_;

        // The normal traction is a pressure
        const nodalScalars nx = curve().normal().col(0).head(n);
        const nodalScalars ny = curve().normal().col(1).head(n);
        const nodalMatrix normal =
            (1 - ratio_)*(1 - scaling_.pressureWeight())
           *(
                nx.asDiagonal()*traction_.topRows(n)
              + ny.asDiagonal()*traction_.bottomRows(n)
            );
        derivative.topRows(n) += nx.asDiagonal()*normal;
        derivative.bottomRows(n) += ny.asDiagonal()*normal;
    }
    return derivative;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::capsule::nodalVectors Foam::capsule::sharpMembrane::contrastTraction
(
    const vector2& driving
)
{
    if (ratio_ == 1)
    {
        return immersedMembrane::contrastTraction(driving);
    }
    const nodalVectors& n = curve().normal();
    const nodalVectors& t = curve().tangent();

    // The real pressure, scaled: see membraneSystem, driven flow
    nodalScalars pressure =
        fluid_.pressure(mu_)
      - (curve().nodes().rowwise() - levelSet().centre())*driving.transpose();
    nodalVectors viscous = fluid_.viscous(n, mu_);
    nodalScalars vorticity = mu_*fluid_.vorticity();
    if (fitSide() > 0)
    {
        const nodalVectors f = resolvedForce();
        pressure -= dot(f, n);
        viscous += scaled(dot(f, t), t);
        vorticity += dot(f, t);
    }
    const nodalVectors shortWaves = basis().unpack(traction_*unresolvedForce());
    pressure -= dot(shortWaves, n);
    viscous += scaled(dot(shortWaves, t), t);

    // The resultant is known; pressure a.n with the constant a fills it
    const nodalVectors traction = ratio_*viscous - scaled(pressure/scaling_.scale(), n);
    Eigen::Matrix<scalar, 2, 2> normals;
    normals.row(0) = curve().resultant(scaled(n.col(0), n));
    normals.row(1) = curve().resultant(scaled(n.col(1), n));
    if (curve().axisymmetric())
    {
        // None away from the axis
        normals(1, 1) = 1;
    }
    const vector2 a =
        (curve().resultant(traction) - momentumRate())*normals.inverse();
    pressure += scaling_.scale()*n*a.transpose();
    if (ratio_ > 1 && !scaling_.inertial() && !curve().axisymmetric())
    {
        // So is the moment about the centroid, which the rate of momentum does
        // not change; shear along the membrane fills it
        const auto moment = [&](const nodalVectors& v)
        {
            const nodalVectors x =
                curve().nodes().rowwise() - curve().centroid();
            return curve().integral
            (
                x.col(0).cwiseProduct(v.col(1))
              - x.col(1).cwiseProduct(v.col(0))
            );
        };
        const nodalVectors corrected =
            ratio_*viscous - scaled(pressure/scaling_.scale(), n);
        viscous -= t*(moment(corrected)/(ratio_*moment(t)));
    }

    membrane_.now().inner.col(0) = vorticity;
    membrane_.now().inner.col(1) = pressure/scaling_.scale();

    return (1 - ratio_)*(viscous - scaling_.pressureWeight()*scaled(pressure, n));
}
