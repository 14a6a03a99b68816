#include "core/base/printable.h"

#include "core/base/utf8.h"

#include <algorithm>

namespace skyseal {

namespace {

struct Range
{
    char32_t first, last;
};

/// In ascending order.
constexpr Range kUnprintable[] = {
    {0x0000, 0x001f},   {0x007f, 0x009f},   {0x00ad, 0x00ad},   {0x034f, 0x034f},   {0x0600, 0x0605},   {0x061c, 0x061c},
    {0x06dd, 0x06dd},   {0x070f, 0x070f},   {0x0890, 0x0891},   {0x08e2, 0x08e2},   {0x115f, 0x1160},   {0x17b4, 0x17b5},
    {0x180b, 0x180f},   {0x200b, 0x200f},   {0x2028, 0x202e},   {0x2060, 0x206f},   {0x3164, 0x3164},   {0xfe00, 0xfe0f},
    {0xfeff, 0xfeff},   {0xffa0, 0xffa0},   {0xfff0, 0xfffb},   {0x110bd, 0x110bd}, {0x110cd, 0x110cd}, {0x13430, 0x1343f},
    {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0000, 0xe0fff},
};

bool isPrintable(const Utf8Character &character)
{
    return character.valid && !isUnprintable(character.value);
}

} // namespace

bool isUnprintable(char32_t character)
{
    const auto range = std::lower_bound(std::begin(kUnprintable), std::end(kUnprintable), character,
                                        [](const Range &at, char32_t value) { return at.last < value; });
    return range != std::end(kUnprintable) && character >= range->first;
}

bool isPrintable(std::string_view text)
{
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (!isPrintable(character))
            return false;
        text.remove_prefix(character.length);
    }
    return true;
}

std::string printable(std::string_view text, char replacement)
{
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (isPrintable(character))
            out += text.substr(0, character.length);
        else
            out += replacement;
        text.remove_prefix(character.length);
    }
    return out;
}

} // namespace skyseal
