/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "rigidShape.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- The rotation by a vector of rotation; none about an axis of symmetry
static solvedTensor turn(const nodalScalars& v, const label d)
{
    solvedTensor result(solvedTensor::Identity(d, d));
    const scalar angle = v.norm();
    if (v.size() == 1)
    {
        const scalar c = std::cos(v(0));
        const scalar s = std::sin(v(0));
        result << c, -s, s, c;
    }
    else if (angle > 0)
    {
        const Eigen::Matrix<scalar, 3, 1> axis = v/angle;
        result = Eigen::AngleAxis<scalar>(angle, axis).toRotationMatrix();
    }
    return result;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::rigidShape::rigidShape(const closedSurface& initial)
:
    reference_(initial.nodes().rowwise() - initial.centroid()),
    start_
    {
        initial.centroid(),
        solvedTensor::Identity(initial.nComponents(), initial.nComponents())
    },
    nTranslations_(initial.axisymmetric() ? 1 : initial.nComponents()),
    nRotations_(initial.nRotations())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::capsule::rigidShape::place Foam::capsule::rigidShape::placeOf
(
    const nodalVectors& nodes
) const
{
    const label d = nodes.cols();
    const solvedVector middle = nodes.colwise().mean();
    const solvedVector referenceMiddle = reference_.colwise().mean();
    const solvedTensor product =
        (nodes.rowwise() - middle).transpose()
       *(reference_.rowwise() - referenceMiddle);

    place result = {middle, solvedTensor::Identity(d, d)};
    if (nRotations_ == 1)
    {
        nodalScalars angle(1);
        angle(0) = std::atan2
        (
            product(1, 0) - product(0, 1),
            product(0, 0) + product(1, 1)
        );
        result.rotation = turn(angle, d);
    }
    else if (nRotations_ == 3)
    {
        const Eigen::JacobiSVD<Eigen::Matrix<scalar, 3, 3>> svd
        (
            product, Eigen::ComputeFullU | Eigen::ComputeFullV
        );
        const Eigen::Matrix<scalar, 3, 3> V = svd.matrixV();
        Eigen::Matrix<scalar, 3, 3> U = svd.matrixU();
        if (U.determinant()*V.determinant() < 0)
        {
            U.col(2) *= -1;
        }
        result.rotation = U*V.transpose();
    }
    result.centre -= referenceMiddle*result.rotation.transpose();
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::rigidShape::nodes
(
    const place& at
) const
{
    return (reference_*at.rotation.transpose()).rowwise() + at.centre;
}


Foam::capsule::rigidShape::place Foam::capsule::rigidShape::moved
(
    const place& from,
    const nodalScalars& step
) const
{
    place result(from);
    result.centre.head(nTranslations_) +=
        step.head(nTranslations_).transpose();
    result.rotation =
        turn(step.tail(nRotations_), from.centre.size())*from.rotation;
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::rigidShape::displacement
(
    const place& from,
    const place& to
) const
{
    nodalScalars result(nModes());
    result.head(nTranslations_) =
        (to.centre - from.centre).head(nTranslations_).transpose();

    const solvedTensor between = to.rotation*from.rotation.transpose();
    if (nRotations_ == 1)
    {
        result(nTranslations_) = std::atan2(between(1, 0), between(0, 0));
    }
    else if (nRotations_ == 3)
    {
        const Eigen::Matrix<scalar, 3, 3> Q = between;
        const Eigen::AngleAxis<scalar> turned(Q);
        result.tail(3) = turned.angle()*turned.axis();
    }
    return result;
}


Foam::capsule::nodalVectors Foam::capsule::rigidShape::mode
(
    const nodalVectors& x,
    const solvedVector& centre,
    const label k
) const
{
    if (k < nTranslations_)
    {
        nodalVectors result(nodalVectors::Zero(x.rows(), x.cols()));
        result.col(k).setOnes();
        return result;
    }
    return turned(nodalVectors(x.rowwise() - centre), k - nTranslations_);
}


Foam::capsule::nodalVectors Foam::capsule::rigidShape::velocity
(
    const nodalVectors& x,
    const solvedVector& centre,
    const nodalScalars& V
) const
{
    nodalVectors result(nodalVectors::Zero(x.rows(), x.cols()));
    for (label k = 0; k < nModes(); ++k)
    {
        result += V(k)*mode(x, centre, k);
    }
    return result;
}


Foam::capsule::nodalScalars Foam::capsule::rigidShape::velocityOf
(
    const nodalVectors& x,
    const solvedVector& centre,
    const nodalVectors& u
) const
{
    nodalMatrix modes(x.size(), nModes());
    for (label k = 0; k < nModes(); ++k)
    {
        modes.col(k) = stacked(mode(x, centre, k));
    }
    return modes.colPivHouseholderQr().solve(stacked(u));
}


Foam::capsule::nodalMatrix Foam::capsule::rigidShape::volumes
(
    const closedSurface& at
) const
{
    nodalMatrix result(nodalMatrix::Zero(nModes(), nModes()));
    result.diagonal().setConstant(at.volume());
    if (nRotations_)
    {
        const solvedTensor m = at.secondMoments();
        result.bottomRightCorner(nRotations_, nRotations_) =
            m.trace()*nodalMatrix::Identity(nRotations_, nRotations_);
        if (nRotations_ == 3)
        {
            result.bottomRightCorner(3, 3) -= m;
        }
    }
    return result;
}

// ************************************************************************* //
