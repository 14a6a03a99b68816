#include "core/engine/common/mavsec_settings.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/base/hex.h"
#include "core/keys/file_io.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::engine {

using crypto::MavsecCipher;

namespace {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t begin = std::min(text.find_first_not_of(kSpace), text.size());
    const std::size_t end = text.find_last_not_of(kSpace);
    return text.substr(begin, end == std::string_view::npos ? 0 : end + 1 - begin);
}

Result<Key32, InputError> readKeyFile(const std::string &path)
{
    auto bytes = keys::readFile(path, keys::FileAccess::Private);
    if (!bytes)
        return tl::unexpected(bytes.error());
    std::optional<Key32> key;
    if (bytes->size() == Key32::size())
        key.emplace(ByteView(*bytes).first<32>());
    else
        key = mavsecKeyFromHex(trimmed(asText(*bytes)));
    sodium_memzero(bytes->data(), bytes->size());
    if (!key)
        return tl::unexpected(InputError{sentence("Reason", "a key is 32 bytes, or 64 hex digits"), path});
    return std::move(*key);
}

} // namespace

std::optional<Key32> mavsecKeyFromHex(std::string_view text)
{
    Key32 key;
    std::size_t length = 0;
    const bool good = text.size() == 2 * Key32::size()
        && sodium_hex2bin(key.mutableView().data(), Key32::size(), text.data(), text.size(), nullptr, &length, nullptr) == 0
        && length == Key32::size();
    return good ? std::optional(std::move(key)) : std::nullopt;
}

Result<MavsecCipher, InputError> makeMavsecCipher(const MavsecSettings &settings)
{
    if (settings.keyFile.empty())
        return makeMavsecCipher(settings, MavsecCipher::publishedKey(settings.kind));
    const auto key = readKeyFile(settings.keyFile);
    if (!key)
        return tl::unexpected(key.error());
    return makeMavsecCipher(settings, *key);
}

Result<MavsecCipher, InputError> makeMavsecCipher(const MavsecSettings &settings, const Key32 &key)
{
    const std::size_t length = MavsecCipher::nonceLength(settings.kind);
    const auto nonce = settings.nonceHex.empty() ? MavsecCipher::publishedNonce(settings.kind) : fromHex(settings.nonceHex);
    if (!nonce || nonce->size() != length)
        return tl::unexpected(InputError{sentence("Reason", "%1 hex digits are expected as nonce")(2 * length), {}});
    auto cipher = MavsecCipher::make(settings.kind, key, *nonce, settings.counter, settings.work);
    if (!cipher)
        return tl::unexpected(InputError{sentence("Reason", "the library refuses the cipher"), {}});
    return std::move(*cipher);
}

} // namespace skyseal::engine
