// Errors are values: a fallible call returns a Result with the error enum of its module.
#pragma once

#include "core/base/reason.h"

#include <tl/expected.hpp>

#include <string>

namespace skyseal {

template<typename T, typename E> using Result = tl::expected<T, E>;

/// An error in user input or in a file: the reason and the position. `message` names the offending text; `line` and `column`
/// are 1-based, 0 = unknown.
struct InputError
{
    Reason message;
    std::string source; ///< file name, URL or option
    std::size_t line = 0;
    std::size_t column = 0;

    /// "source:line:column: message" with the unknown parts left out.
    Reason reason() const
    {
        std::string place = source;
        if (line)
            place += ":" + std::to_string(line);
        if (line && column)
            place += ":" + std::to_string(column);
        return place.empty() ? message : sentence("Reason", "%1: %2")(place, message);
    }
    /// The reason in English.
    std::string text() const { return reason().text(); }
};

} // namespace skyseal
