/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "solverFunctions.H"
#include "input.H"
#include "etcFiles.H"
#include "functionObjectList.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "stringOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace solverFunctions
{

//- Directory that holds the project's etc
static const fileName site(CAPSULE_SITE);


//- Name of the dictionary of a function object with arguments, as 'Q(U)'
static word baseName(const std::string& nameArgs)
{
    return word::validate(nameArgs.substr(0, nameArgs.find('(')));
}


//- Does a directory or one below it have a file of this name?
static bool has(const fileName& dir, const word& name)
{
    if (isFile(dir/name))
    {
        return true;
    }
    for (const fileName& d : readDir(dir, fileName::DIRECTORY))
    {
        if (has(dir/d, name))
        {
            return true;
        }
    }
    return false;
}


//- Does OpenFOAM find a dictionary of this name?
static bool isDefined(const word& name)
{
    if (isFile(fileName(stringOps::expand("<system>"))/name))
    {
        return true;
    }
    for
    (
        const fileName& dir
      : findEtcDirs(functionObjectList::functionObjectDictPath)
    )
    {
        if (has(dir, name))
        {
            return true;
        }
    }
    return false;
}


//- What to say of a type that needs a turbulence model; empty of others
static string withoutTurbulence(const word& type)
{
    if (type == "wallShearStress")
    {
        return
            "needs a turbulence model, which capsuleFoam does not have;"
            " permitted: wallStress of libs (capsule), the shear stress in Pa";
    }
    if (type == "turbulenceFields" || type == "yPlus")
    {
        return
            "needs a turbulence model, which capsuleFoam does not have:"
            " flow is laminar";
    }
    return string::null;
}


//- Stop if forces are not told the density of the liquids
static void checkDensity(const dictionary& dict, const Time& runTime)
{
    const IOdictionary properties
    (
        IOobject
        (
            "transportProperties",
            runTime.constant(),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const scalar rho =
        input::getPositive(properties, "rho", dimDensity, "kg/m3");

    if (input::getOrDefault<word>(dict, "rho", "rho") != "rhoInf")
    {
        FatalIOErrorInFunction(dict)
            << "Entry rho must be rhoInf, with rhoInf " << rho
            << ": there is no field of the density" << exit(FatalIOError);
    }
    const scalar given = input::get<scalar>(dict, "rhoInf");
    if (!(mag(given - rho) <= 1e-6*rho))
    {
        FatalIOErrorInFunction(dict)
            << "Entry rhoInf is " << given << "; it must be " << rho
            << " [kg/m3], rho in " << properties.objectPath()
            << ": forces have the pressure in Pa, and multiply the kinematic"
            << " viscosity by it" << exit(FatalIOError);
    }
}

} // End namespace solverFunctions
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::capsule::solverFunctions::provide
(
    int argc,
    const char* const* argv
)
{
    const fileName etc(site/"etc");
    const fileName other(getEnv("WM_PROJECT_SITE"));
    bool named = false;
    for (int i = 1; i + 1 < argc; ++i)
    {
        const std::string option(argv[i]);
        if (option == "-func" || option == "-funcs")
        {
            std::string names(argv[i + 1]);
            names = names.substr(names[0] == '(' ? 1 : 0);
            for (const auto& name : stringOps::split(names, ' '))
            {
                named =
                    named
                 || has
                    (
                        etc/functionObjectList::functionObjectDictPath,
                        baseName(name.str())
                    );
            }
        }
    }
    if
    (
        isDir(etc)
     && (
            named
         || !isDir
            (
                other.empty()
              ? fileName(getEnv("WM_PROJECT_DIR"))/"site/etc"
              : other/"etc"
            )
        )
    )
    {
        setEnv("WM_PROJECT_SITE", site, true);
    }
}


void Foam::capsule::solverFunctions::check(const Time& runTime)
{
    const dictionary* functions = runTime.controlDict().findDict("functions");
    if (!functions)
    {
        return;
    }
    for (const entry& e : *functions)
    {
        const dictionary* dict = e.dictPtr();
        if (!dict || !dict->getOrDefault<bool>("enabled", true))
        {
            continue;
        }
        const word type(dict->getOrDefault<word>("type", word::null));
        const string wrong(withoutTurbulence(type));
        if (!wrong.empty())
        {
            FatalIOErrorInFunction(*dict)
                << "Entry type is " << type << ", which " << wrong.c_str()
                << exit(FatalIOError);
        }
        if (type == "forces" || type == "forceCoeffs")
        {
            checkDensity(*dict, runTime);
        }
    }
}


void Foam::capsule::solverFunctions::check
(
    const argList& args,
    const Time& runTime
)
{
    wordList names;
    if (args.found("func"))
    {
        names.append(baseName(args["func"]));
    }
    if (args.found("funcs"))
    {
        for (const word& name : args.getList<word>("funcs"))
        {
            names.append(baseName(name));
        }
    }
    for (const word& name : names)
    {
        const string wrong(withoutTurbulence(name));
        if (!wrong.empty())
        {
            FatalErrorInFunction
                << "Function object " << name << ' ' << wrong.c_str()
                << exit(FatalError);
        }
        if (!isDefined(name))
        {
            FatalErrorInFunction
                << "Cannot find function object " << name << nl
                << "    Permitted: the name of a file in "
                << runTime.system() << ", or one that capsuleFoam"
                << " -postProcess -list lists" << exit(FatalError);
        }
    }
    if (names.empty() && !args.found("dict"))
    {
        check(runTime);
    }
}
