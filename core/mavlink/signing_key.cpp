#include "core/mavlink/signing_key.h"

#include "core/base/secret_bytes.h"

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

Result<Key32, InputError> parseSigningKey(ByteView content, const std::string &source)
{
    Key32 key;
    bool good = content.size() == Key32::size();
    if (good) {
        std::copy(content.begin(), content.end(), key.mutableView().begin());
    } else if (content.size() <= kLongestFile) {
        std::string_view text = asText(content);
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
    if (!good)
        return tl::unexpected(InputError{"a signing key is 32 bytes, or 64 hex digits", source});
    return key;
}

Result<Key32, InputError> readSigningKey(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return tl::unexpected(InputError{"the signing key cannot be read", path});
    std::array<char, kLongestFile + 1> content{};
    file.read(content.data(), content.size());
    auto key = parseSigningKey(asBytes({content.data(), static_cast<std::size_t>(file.gcount())}), path);
    sodium_memzero(content.data(), content.size());
    return key;
}

} // namespace skyseal::mavlink
