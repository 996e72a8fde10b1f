/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "linearSchemes.H"
#include "input.H"
#include "ITstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::linearSchemes::check
(
    const word& schemes,
    const word& term,
    ITstream& (fvMesh::*scheme)(const word&) const,
    const List<string>& permitted
) const
{
    const dictionary& dict = input::subDict(mesh_.schemesDict(), schemes);
    const string found = input::guarded
    (
        dict,
        term,
        [&]()
        {
            if (dict.found(term))
            {
                input::tokens(dict, term);
            }
            ITstream& is = (mesh_.*scheme)(term);
            OStringStream words;
            for (label i = 0; i < is.size(); ++i)
            {
                words << (i ? " " : "") << is[i];
            }
            is.rewind();
            return string(words.str());
        }
    );
    if (permitted.found(found))
    {
        return;
    }

    OStringStream list;
    forAll(permitted, i)
    {
        list << (i ? ", " : "") << permitted[i].c_str();
    }
    FatalIOErrorInFunction(dict)
        << "Entry " << term << " is " << found.c_str()
        << (dict.found(term) ? "" : " (by default)")
        << "; the corrections at membranes do not know it. Permitted with"
        << " membranes: " << list.str().c_str() << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::linearSchemes::linearSchemes(const fvMesh& mesh)
:
    mesh_(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::linearSchemes::check() const
{
    const List<string> interpolation({"linear"});
    const List<string> gradient({"Gauss linear", "Gauss"});
    const List<string> convection({"Gauss linear"});
    const List<string> normal({"orthogonal", "uncorrected", "corrected"});
    List<string> laplacian;
    for (const string& n : normal)
    {
        laplacian.append("Gauss linear " + n);
    }

    for (const word term : {"flux(U)", "interpolate(grad(p))"})
    {
        check
        (
            "interpolationSchemes", term, &fvMesh::interpolationScheme,
            interpolation
        );
    }
    for (const word term : {"grad(p)", "grad(U)"})
    {
        check("gradSchemes", term, &fvMesh::gradScheme, gradient);
    }
    check("snGradSchemes", "snGrad(p)", &fvMesh::snGradScheme, normal);
    check
    (
        "laplacianSchemes", "laplacian(mu,U)", &fvMesh::laplacianScheme,
        laplacian
    );
    if (word(mesh_.ddtScheme("ddt(U)")) != "steadyState")
    {
        check("divSchemes", "div(phi,U)", &fvMesh::divScheme, convection);
    }
}
