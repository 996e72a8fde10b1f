/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "directFlowSolver.H"
#include "wholeFile.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Writer of the coefficients of a matrix
class matrixWriter
:
    public regIOobject
{
    const fvVectorMatrix& matrix_;

public:

    matrixWriter(const IOobject& io, const fvVectorMatrix& matrix)
    :
        regIOobject(io),
        matrix_(matrix)
    {}

    //- The file is read as a dictionary
    virtual const word& type() const
    {
        return IOdictionary::typeName;
    }

    virtual bool writeData(Ostream& os) const
    {
        const UList<scalar>& diagonal = matrix_.diag();
        const UList<scalar>& upper = matrix_.upper();
        diagonal.writeEntry("diagonal", os);
        upper.writeEntry("upper", os);
        if (matrix_.asymmetric())
        {
            const UList<scalar>& lower = matrix_.lower();
            lower.writeEntry("lower", os);
        }
        forAll(matrix_.internalCoeffs(), patchi)
        {
            const UList<vector>& boundary = matrix_.internalCoeffs()[patchi];
            boundary.writeEntry(word("boundary" + Foam::name(patchi)), os);
        }
        return os.good();
    }
};


//- Coefficients from an entry, which must have as many
template<class Type>
static void take
(
    const dictionary& dict,
    Field<Type>& coefficients,
    const word& entry
)
{
    const Field<Type> found(input::get<Field<Type>>(dict, entry));
    if (found.size() != coefficients.size())
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " has " << found.size()
            << " coefficients, but the mesh takes " << coefficients.size()
            << exit(FatalIOError);
    }
    coefficients = found;
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::capsule::directFlowSolver::matrixFile
(
    const IOobject::readOption read
) const
{
    return IOobject
    (
        "flowMatrix",
        mesh_.time().timeName(),
        "uniform",
        mesh_.time(),
        read,
        IOobject::NO_WRITE,
        false
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fileNameList Foam::capsule::directFlowSolver::write() const
{
    if (stale_ || !varies_)
    {
        return fileNameList();
    }

    writeAtomically
    (
        matrixWriter(matrixFile(IOobject::NO_READ), *factorised_),
        mesh_.time().writeFormat()
    );
    return fileNameList(1, fileName("uniform/flowMatrix"));
}


void Foam::capsule::directFlowSolver::resume()
{
    IOobject io(matrixFile(IOobject::MUST_READ));
    if (!isFile(io.objectPath()))
    {
        return;
    }
    const IOdictionary dict(io);

    fvVectorMatrix matrix(U_, dimForce);
    take(dict, matrix.diag(), "diagonal");
    take(dict, matrix.upper(), "upper");
    if (dict.found("lower"))
    {
        take(dict, matrix.lower(), "lower");
    }
    forAll(matrix.internalCoeffs(), patchi)
    {
        take
        (
            dict,
            matrix.internalCoeffs()[patchi],
            word("boundary" + Foam::name(patchi))
        );
    }

    set(matrix);
    factorise(matrix);
    varies_ = true;
}
