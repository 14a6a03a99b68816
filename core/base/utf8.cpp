#include "core/base/utf8.h"

namespace skyseal {

Utf8Character firstCharacter(std::string_view text)
{
    const auto at = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned lead = at(0);
    if (lead < 0x80)
        return {1, true, lead};
    if (lead < 0xc2 || lead > 0xf4)
        return {1, false};
    const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    // The range of the second byte excludes overlong forms, surrogates and values beyond U+10FFFF.
    unsigned low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    unsigned high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    char32_t value = lead & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (at(i) < low || at(i) > high)
            return {i, false};
        value = value << 6 | (at(i) & 0x3f);
        low = 0x80;
        high = 0xbf;
    }
    return {length, true, value};
}

bool isUtf8(std::string_view text)
{
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (!character.valid)
            return false;
        text.remove_prefix(character.length);
    }
    return true;
}

} // namespace skyseal
