#include "core/keys/sealed_key.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/x25519.h"
#include "core/base/hex.h"
#include "core/keys/file_io.h"
#include "core/keys/public_key_text.h"
#include "core/keys/text_lines.h"

#include <sodium.h>

#include <charconv>

namespace skyseal::keys {

using crypto::PassphraseError;

static constexpr std::string_view kDerivation = "argon2id ";
static constexpr int kLineVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;
static constexpr std::size_t kSealedLength = 64; // of 48 bytes in base64

static bool takeNumber(std::string_view &text, std::uint32_t &number)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end == text.data() + text.size() || *end != ' ' || text.starts_with('0'))
        return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
    return true;
}

/// The line must be exactly as text() writes it, since its bytes are authenticated.
static bool readDerivation(std::string_view line, SealedKey &key)
{
    if (!line.starts_with(kDerivation))
        return false;
    line.remove_prefix(kDerivation.size());
    if (!takeNumber(line, key.cost.passes) || !takeNumber(line, key.cost.memoryKiB) || line.size() != 2 * key.salt.size())
        return false;
    const auto salt = fromHex(line);
    if (!salt || toHex(*salt) != line)
        return false;
    std::copy(salt->begin(), salt->end(), key.salt.begin());
    return true;
}

static bool readSealed(std::string_view line, crypto::SealedSecret &sealed)
{
    std::size_t size = 0;
    return line.size() == kSealedLength
        && sodium_base642bin(sealed.data(), sealed.size(), line.data(), line.size(), nullptr, &size, nullptr, kLineVariant) == 0
        && size == sealed.size();
}

Result<SealedKey, InputError> SealedKey::parse(std::string_view text, const std::string &source)
{
    TextLines lines(text);
    const auto refuse = [&](Reason why) { return tl::unexpected(fileError(source, std::move(why), lines.number())); };
    if (lines.next() != kSealedKeyHeader)
        return refuse(sentence("Reason", "is not a sealed key file of Skyseal: it does not begin with \"%1\"")(
            std::string(kSealedKeyHeader)));
    const auto truncated = [&source] {
        return tl::unexpected(fileError(source, sentence("Reason", "is truncated: a sealed key has four lines")));
    };
    SealedKey key;
    std::optional<std::string_view> line = lines.nextContent();
    if (!line)
        return truncated();
    if (!readDerivation(*line, key))
        return refuse(sentence("Reason", "\"argon2id PASSES KIB SALT\" is expected here"));
    if (!isAcceptable(key.cost))
        return refuse(sentence(
            "Reason",
            "asks for %1 passes over %2 KiB, which is outside of what is accepted (1 to 16 passes, 8192 to 1048576 KiB)")(
            key.cost.passes, key.cost.memoryKiB));
    line = lines.nextContent();
    if (!line)
        return truncated();
    const auto publicKey = publicKeyFromText(*line);
    if (!publicKey)
        return refuse(sentence("Reason", "a public key is expected here"));
    key.publicKey = *publicKey;
    line = lines.nextContent();
    if (!line)
        return truncated();
    if (!readSealed(*line, key.sealed))
        return refuse(line->size() < kSealedLength ? sentence("Reason", "has a truncated key")
                                                   : sentence("Reason", "has a damaged key"));
    if (lines.nextContent())
        return refuse(sentence("Reason", "has more behind the key"));
    return key;
}

std::string SealedKey::clearLines() const
{
    std::string out(kSealedKeyHeader);
    out.append("\n").append(kDerivation).append(std::to_string(cost.passes)).append(" ").append(std::to_string(cost.memoryKiB));
    out.append(" ").append(toHex(salt)).append("\n").append(publicKeyText(publicKey)).append("\n");
    return out;
}

std::string SealedKey::text() const
{
    std::string out = clearLines();
    out.insert(kSealedKeyHeader.size() + 1, "# Keep this file to yourself. It opens with your passphrase.\n");
    char base64[kSealedLength + 1];
    sodium_bin2base64(base64, sizeof base64, sealed.data(), sealed.size(), kLineVariant);
    return out.append(base64).append("\n");
}

Result<SealedKey, PassphraseError> SealedKey::seal(const crypto::X25519KeyPair &pair, const crypto::Passphrase &passphrase,
                                                   const crypto::PassphraseCost &cost, RandomSource &random)
{
    SealedKey key;
    key.cost = cost;
    random.fill(key.salt);
    key.publicKey = pair.publicKey;
    const auto sealed = crypto::sealWithPassphrase(pair.secret, passphrase, cost, key.salt, asBytes(key.clearLines()));
    if (!sealed)
        return tl::unexpected(sealed.error());
    key.sealed = *sealed;
    return key;
}

Result<crypto::X25519KeyPair, PassphraseError> SealedKey::open(const crypto::Passphrase &passphrase) const
{
    auto secret = crypto::openWithPassphrase(sealed, passphrase, cost, salt, asBytes(clearLines()));
    if (!secret)
        return tl::unexpected(secret.error());
    crypto::X25519KeyPair pair = crypto::X25519KeyPair::fromSecret(std::move(*secret));
    if (pair.publicKey != publicKey)
        return tl::unexpected(PassphraseError::DoesNotOpen);
    return pair;
}

} // namespace skyseal::keys
