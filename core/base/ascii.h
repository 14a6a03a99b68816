// Comparison of ASCII text without regard to case.
#pragma once

#include <algorithm>
#include <string_view>

namespace skyseal {

constexpr char asciiLower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// True if the texts differ in nothing but the case of ASCII letters.
constexpr bool equalIgnoringCase(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return asciiLower(x) == asciiLower(y); });
}

} // namespace skyseal
