/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "input.H"
#include "dimensionedType.H"
#include "error.H"
#include "OStringStream.H"
#include <new>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{
namespace input
{

//- What bounds permit
template<class Type>
static string between(const Type& lower, const Type& upper)
{
    OStringStream text;
    text << lower << " to " << upper;
    return text.str();
}

} // End namespace input
} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<class Reader>
auto Foam::capsule::input::guarded
(
    const dictionary& dict,
    const word& entry,
    const Reader& reader,
    const string& permitted
) -> decltype(reader())
{
    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();
    // A list longer than the memory: OpenFOAM's handler aborts
    const std::new_handler handler = std::set_new_handler(nullptr);
    const auto restore = [&]()
    {
        std::set_new_handler(handler);
        FatalError.throwExceptions(throwing);
        FatalIOError.throwExceptions(throwingIO);
    };

    string message;
    try
    {
        auto&& result = reader();
        restore();
        return std::forward<decltype(reader())>(result);
    }
    catch (const Foam::error& err)
    {
        message = err.message();
    }
    catch (const std::exception& err)
    {
        message = err.what();
    }

    restore();
    FatalIOErrorInFunction(dict)
        << "Entry " << entry << ": " << message.c_str()
        << (permitted.empty() ? "" : "; permitted: ") << permitted.c_str()
        << exit(FatalIOError);
    return reader();   // never reached
}


template<class Type>
Type Foam::capsule::input::get
(
    const dictionary& dict,
    const word& entry,
    const string& permitted
)
{
    return guarded
    (
        dict,
        entry,
        [&]()
        {
            tokens(dict, entry);
            return dict.get<Type>(entry);
        },
        permitted
    );
}


template<class Type>
Type Foam::capsule::input::getOrDefault
(
    const dictionary& dict,
    const word& entry,
    const Type& deflt
)
{
    return dict.found(entry) ? get<Type>(dict, entry) : deflt;
}


template<class Type>
Type Foam::capsule::input::getBetween
(
    const dictionary& dict,
    const word& entry,
    const Type& lower,
    const Type& upper
)
{
    const string permitted(between(lower, upper));
    const Type value(get<Type>(dict, entry, permitted));
    // NaN is not between bounds
    if (!(value >= lower && value <= upper))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is " << value << "; permitted: "
            << permitted.c_str() << exit(FatalIOError);
    }
    return value;
}


template<class Type>
Type Foam::capsule::input::getBetweenOrDefault
(
    const dictionary& dict,
    const word& entry,
    const Type& deflt,
    const Type& lower,
    const Type& upper
)
{
    return
        dict.found(entry)
      ? getBetween<Type>(dict, entry, lower, upper)
      : deflt;
}


template<class Type>
Type Foam::capsule::input::getQuantity
(
    const dictionary& dict,
    const word& entry,
    const dimensionSet& dimensions,
    const string& permitted
)
{
    return guarded
    (
        dict,
        entry,
        [&]()
        {
            checkDimensions(dict, entry, dimensions);
            return dimensioned<Type>(entry, dimensions, dict).value();
        },
        permitted
    );
}
