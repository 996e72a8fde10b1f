/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "ownership.H"
#include "releases.H"
#include "scalarList.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::capsule::ownership::share(std::vector<nodalMatrix>& results)
{
    if (!Pstream::parRun())
    {
        return;
    }

    // Of each processor, one result after the other: rows, columns, values
    List<scalarList> sent(Pstream::nProcs());
    DynamicList<scalar> mine;
    for (label i = 0; i < label(results.size()); ++i)
    {
        if (owns(i))
        {
            const nodalMatrix& result = results[i];
            mine.append(result.rows());
            mine.append(result.cols());
            for (Eigen::Index k = 0; k < result.size(); ++k)
            {
                mine.append(result.data()[k]);
            }
        }
    }
    sent[Pstream::myProcNo()].transfer(mine);
    allGatherList(sent);

    labelList next(Pstream::nProcs(), Zero);
    for (label i = 0; i < label(results.size()); ++i)
    {
        const label proci = i % Pstream::nProcs();
        const scalar* at = sent[proci].cdata() + next[proci];
        const label rows = label(at[0]);
        const label columns = label(at[1]);
        results[i] = Eigen::Map<const nodalMatrix>(at + 2, rows, columns);
        next[proci] += 2 + rows*columns;
    }
}


// ************************************************************************* //
