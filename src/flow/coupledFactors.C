/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "coupledFactors.H"
#include "nestedDissection.H"
#include "error.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::coupledFactors::pivotThreshold_ = 0.1;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::coupledFactors::setOrder
(
    const Eigen::SparseMatrix<scalar>& matrix
)
{
    labelListList neighbours(centres_.rows());
    forAll(neighbours, celli)
    {
        DynamicList<label> beside;
        typedef Eigen::SparseMatrix<scalar>::InnerIterator iterator;
        for (iterator it(matrix, 3*celli); it; ++it)
        {
            if (it.row() % 3 == 0 && it.row() != it.col())
            {
                beside.append(it.row()/3);
            }
        }
        neighbours[celli].transfer(beside);
    }

    const nestedDissection dissection(centres_, neighbours);
    order_.resize(dissection.order().size());
    forAll(dissection.order(), i)
    {
        order_.indices()(dissection.order()[i]) = i;
    }
}


void Foam::capsule::coupledFactors::setScale
(
    const Eigen::SparseMatrix<scalar>& matrix
)
{
    const nodalScalars diagonal = matrix.diagonal();
    scale_ = nodalScalars::Ones(diagonal.size());
    for (Eigen::Index i = 2; i < diagonal.size(); i += 3)
    {
        scale_(i) = std::sqrt(std::abs(diagonal(i - 2)/diagonal(i)));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::coupledFactors::coupledFactors(const nodalVectors& centres)
:
    centres_(centres)
{
    factors_.setPivotThreshold(pivotThreshold_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::coupledFactors::compute
(
    const Eigen::SparseMatrix<scalar>& matrix
)
{
    if (order_.size() == 0)
    {
        setOrder(matrix);
    }
    setScale(matrix);

    const Eigen::SparseMatrix<scalar> scaled =
        scale_.asDiagonal()*matrix*scale_.asDiagonal();
    Eigen::SparseMatrix<scalar> ordered;
    ordered = scaled.twistedBy(order_);
    factors_.compute(ordered);
    if (factors_.info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "The coupled matrix cannot be factorised: "
            << factors_.lastErrorMessage().c_str() << exit(FatalError);
    }
}


Foam::capsule::nodalScalars Foam::capsule::coupledFactors::solve
(
    const nodalScalars& b
) const
{
    const nodalScalars ordered =
        factors_.solve(order_*scale_.cwiseProduct(b));
    return scale_.cwiseProduct(order_.transpose()*ordered);
}


// ************************************************************************* //
