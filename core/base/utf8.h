// Validates UTF-8 (RFC 3629) in text from other programs.
#pragma once

#include <cstddef>
#include <string_view>

namespace skyseal {

/// U+FFFD, the replacement for invalid bytes.
inline constexpr std::string_view kReplacementCharacter = "\xef\xbf\xbd";

/// The first character of a text, or the maximal invalid part that replaces one (at least 1 byte).
struct Utf8Character
{
    std::size_t length = 1;
    bool valid = false;
    char32_t value = 0; ///< code point of a valid character
};

/// `text` must not be empty. Overlong forms, surrogates and values beyond U+10FFFF are invalid.
Utf8Character firstCharacter(std::string_view text);

bool isUtf8(std::string_view text);

} // namespace skyseal
