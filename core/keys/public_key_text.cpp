#include "core/keys/public_key_text.h"

#include "core/base/hex.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/hash.h"
#include "core/keys/checked_base64.h"

#include <algorithm>

namespace skyseal::keys {

static constexpr std::string_view kPrefix = "skyseal:";
static constexpr std::string_view kCheckLabel = "skyseal public key v1";

static std::string_view trimmed(std::string_view text)
{
    static constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::string publicKeyText(const PublicKey &key)
{
    return std::string(kPrefix) + toCheckedBase64(key, kCheckLabel);
}

Result<PublicKey, InputError> publicKeyFromText(std::string_view text)
{
    text = trimmed(text);
    // The text is not quoted: it may be a private key that was pasted by mistake.
    const auto refuse = [](const Reason &why) {
        return tl::unexpected(InputError{sentence("Reason", "this is not a public key: %1")(why), {}});
    };
    if (!text.starts_with(kPrefix))
        return refuse(sentence("Reason", "it does not begin with \"skyseal:\""));
    text.remove_prefix(kPrefix.size());
    if (text.size() != kCheckedBase64Length)
        return refuse(sentence("Reason", "48 characters follow \"skyseal:\", here %1")(text.size()));
    const std::optional<Key32> bytes = fromCheckedBase64(text, kCheckLabel);
    if (!bytes)
        return refuse(sentence("Reason", "its check does not fit, so some character is wrong"));
    PublicKey key{};
    std::copy(bytes->view().begin(), bytes->view().end(), key.begin());
    return key;
}

std::string fingerprint(const PublicKey &key)
{
    std::array<std::uint8_t, 32> digest{};
    crypto::blake2b(digest, {asBytes("skyseal fingerprint v1"), key});
    std::string out;
    for (std::size_t i = 0; i < digest.size(); i += 2) {
        if (!out.empty())
            out.push_back(' ');
        out += toHex(ByteView(digest).subspan(i, 2));
    }
    return out;
}

} // namespace skyseal::keys
