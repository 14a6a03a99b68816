// Formatted text at the end of a string, for the writers of figures.
#pragma once

#include "core/base/number_text.h"

#include <concepts>
#include <string>
#include <string_view>

namespace skyseal::experiment {

namespace detail {

/// A place or a length in a figure: a tenth of a pixel is enough.
inline std::string figureText(double length)
{
    return fixedText(length, 1);
}

inline std::string figureText(std::integral auto number)
{
    return std::to_string(number);
}

inline std::string_view figureText(const char *text)
{
    return text;
}

} // namespace detail

/// Appends the pattern with the values in place of its markers {}, one for each value.
template<typename... Values> void put(std::string &out, std::string_view pattern, const Values &...values)
{
    const auto append = [&](std::string_view value) {
        const std::size_t marker = pattern.find("{}");
        out.append(pattern.substr(0, marker)).append(value);
        pattern.remove_prefix(marker + 2);
    };
    (append(detail::figureText(values)), ...);
    out += pattern;
}

} // namespace skyseal::experiment
