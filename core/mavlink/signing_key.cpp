#include "core/mavlink/signing_key.h"

#include <sodium.h>

#include <array>
#include <fstream>

namespace skyseal::mavlink {

namespace {

constexpr std::size_t kLongestFile = 128;

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

} // namespace

Result<Key32, InputError> readSigningKey(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return tl::unexpected(InputError{"the signing key cannot be read", path});
    std::array<char, kLongestFile + 1> content{};
    file.read(content.data(), content.size());
    std::string_view text(content.data(), static_cast<std::size_t>(file.gcount()));

    Key32 key;
    bool good = text.size() == Key32::size();
    if (good) {
        std::copy(text.begin(), text.end(), key.mutableView().begin());
    } else if (text.size() <= kLongestFile) {
        while (!text.empty() && isSpace(text.front()))
            text.remove_prefix(1);
        while (!text.empty() && isSpace(text.back()))
            text.remove_suffix(1);
        std::size_t length = 0;
        std::uint8_t *out = key.mutableView().data();
        good = text.size() == 2 * Key32::size()
            && sodium_hex2bin(out, Key32::size(), text.data(), text.size(), nullptr, &length, nullptr) == 0
            && length == Key32::size();
    }
    sodium_memzero(content.data(), content.size());
    if (!good)
        return tl::unexpected(InputError{"a signing key is 32 bytes, or 64 hex digits", path});
    return key;
}

} // namespace skyseal::mavlink
