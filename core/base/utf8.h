// Which bytes are text in UTF-8 (RFC 3629), for what other programs send and claim to be one.
#pragma once

#include <cstddef>
#include <string_view>

namespace skyseal {

/// U+FFFD, which stands for what is no text.
inline constexpr std::string_view kReplacementCharacter = "\xef\xbf\xbd";

/// The start of a text: one whole character, or as many bytes as one could have begun with, 1 at least.
struct Utf8Character
{
    std::size_t length = 1;
    bool valid = false;
};

/// Of a text that is not empty. Only shortest forms are valid, no surrogates, and nothing beyond U+10FFFF.
Utf8Character firstCharacter(std::string_view text);

bool isUtf8(std::string_view text);

} // namespace skyseal
