/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "wholeFile.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "fileOperation.H"
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Write an object to a path; did all of it get there?
static bool written
(
    const regIOobject& object,
    const fileName& path,
    const IOstream::streamFormat format
)
{
    OFstream os(path);
    os.format(format);
    os.precision(17);
    const bool good =
        os.good() && object.writeHeader(os, object.type())
     && object.writeData(os);
    IOobject::writeEndDivider(os);
    os.stdStream().flush();
    return good && os.good();
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::capsule::writeAtomically
(
    const regIOobject& object,
    const IOstream::streamFormat format
)
{
    const fileName path(object.objectPath());
    bool good;
    if (fileHandler().type() == "uncollated")
    {
        const fileName part(path + ".part");
        mkDir(path.path());
        good = written(object, part, format) && mv(part, path);
    }
    else
    {
        // Put together with those of other processors by the file handler
        const unsigned precision = IOstream::defaultPrecision(17);
        good = object.write();
        IOstream::defaultPrecision(precision);
    }

    if (!good)
    {
        FatalErrorInFunction
            << "Cannot write " << path << ": is the disk full?" << nl
            << "    This time is not whole: remove its directory to go on from"
            << " an earlier one." << exit(FatalError);
    }
}


Foam::string Foam::capsule::fileDefect(const fileName& path)
{
    if (fileHandler().type() != "uncollated" || isFile(path + ".gz", false))
    {
        return string::null;
    }
    if (!isFile(path, false))
    {
        return "is missing";
    }

    std::ifstream is(path, std::ios::binary | std::ios::ate);
    const std::streamoff length = is.tellg();
    const std::streamoff tail = min(length, std::streamoff(100));
    std::string end(tail, ' ');
    is.seekg(length - tail);
    is.read(&end[0], tail);

    const std::string stars("**** //\n");
    const bool whole =
        is.good() && end.size() > stars.size()
     && end.compare(end.size() - stars.size(), stars.size(), stars) == 0;
    return whole ? string::null : string("is cut short");
}
