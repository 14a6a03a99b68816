// Errors are values: a fallible call returns a Result with the error enum of its module.
#pragma once

#include <tl/expected.hpp>

#include <string>

namespace skyseal {

template<typename T, typename E> using Result = tl::expected<T, E>;

/// An error in user input or in a file: the reason and the position. `message` is one plain English
/// sentence without a full stop, naming the offending text; `line` and `column` are 1-based, 0 = unknown.
struct InputError
{
    std::string message;
    std::string source; ///< file name, URL or option
    std::size_t line = 0;
    std::size_t column = 0;

    /// "source:line:column: message" with the unknown parts left out.
    std::string text() const
    {
        std::string out = source;
        if (line)
            out += ":" + std::to_string(line);
        if (line && column)
            out += ":" + std::to_string(column);
        return out.empty() ? message : out + ": " + message;
    }
};

} // namespace skyseal
