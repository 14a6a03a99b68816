#include "core/keys/secret_file.h"

#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "core/base/secret_bytes.h"
#include "core/keys/checked_base64.h"
#include "core/keys/file_io.h"
#include "core/keys/sealed_key.h"
#include "core/keys/text_lines.h"

namespace skyseal::keys {

using crypto::X25519KeyPair;

static constexpr std::string_view kAnyHeader = "skyseal-";
static constexpr std::size_t kLongestHeader = 40;

static std::string_view headerOf(SecretKind kind)
{
    return kind == SecretKind::PrivateKey ? "skyseal-private-key-v1" : "skyseal-preshared-key-v1";
}

static bool isSealed(std::string_view text)
{
    return TextLines(text).next() == kSealedKeyHeader;
}

/// Errors never quote a file beyond its first line, which may contain a key.
Result<Key32, InputError> parseSecretFile(SecretKind kind, std::string_view text, const std::string &source)
{
    TextLines lines(text);
    const std::string_view header = lines.next();
    const std::string expected(headerOf(kind));
    if (header != expected) {
        if (header.starts_with(kAnyHeader) && header.size() < kLongestHeader)
            return tl::unexpected(
                fileError(source, sentence("Reason", "holds \"%1\", not \"%2\"")(std::string(header), expected), 1));
        return tl::unexpected(
            fileError(source, sentence("Reason", "is not a key file of Skyseal: it does not begin with \"%1\"")(expected), 1));
    }
    std::optional<Key32> secret;
    while (const auto content = lines.nextContent()) {
        if (secret)
            return tl::unexpected(fileError(source, sentence("Reason", "has more than one key"), lines.number()));
        if (content->size() < kCheckedBase64Length)
            return tl::unexpected(fileError(source, sentence("Reason", "has a truncated key"), lines.number()));
        secret = fromCheckedBase64(*content, expected);
        if (!secret)
            return tl::unexpected(
                fileError(source, sentence("Reason", "has a damaged key: its check does not fit"), lines.number()));
    }
    if (!secret)
        return tl::unexpected(fileError(source, sentence("Reason", "is truncated: it has no key")));
    return std::move(*secret);
}

/// Calls `read` with the file's text, which is wiped afterwards.
template<typename Read> static auto withPrivateFile(const std::string &path, Read read) -> decltype(read(std::string_view()))
{
    auto content = readFile(path, FileAccess::Private);
    if (!content)
        return tl::unexpected(content.error());
    auto out = read(asText(*content));
    wipeSecret(*content);
    return out;
}

static InputError noMemory(const std::string &path, const crypto::PassphraseCost &cost)
{
    return fileError(
        path,
        sentence("Reason", "needs %1 MiB of memory for its passphrase, more than this machine gives")(cost.memoryKiB / 1024));
}

static Result<X25519KeyPair, InputError> openSealed(const SealedKey &key, const std::string &source, const AskPassphrase &ask)
{
    if (!ask)
        return tl::unexpected(fileError(source, sentence("Reason", "is sealed with a passphrase, and none is given")));
    for (int attempt = 0;; ++attempt) {
        const auto passphrase = ask(source, attempt);
        if (!passphrase)
            return tl::unexpected(passphrase.error());
        auto pair = key.open(*passphrase);
        if (pair)
            return std::move(*pair);
        if (pair.error() == crypto::PassphraseError::NoMemory)
            return tl::unexpected(noMemory(source, key.cost));
    }
}

Result<X25519KeyPair, InputError> parseIdentity(std::string_view text, const std::string &source, const AskPassphrase &ask)
{
    if (isSealed(text))
        return SealedKey::parse(text, source).and_then([&](const SealedKey &key) { return openSealed(key, source, ask); });
    return parseSecretFile(SecretKind::PrivateKey, text, source).map([](Key32 &&secret) {
        return X25519KeyPair::fromSecret(std::move(secret));
    });
}

Result<X25519KeyPair, InputError> loadIdentity(const std::string &path, const AskPassphrase &ask)
{
    return withPrivateFile(path, [&](std::string_view text) { return parseIdentity(text, path, ask); });
}

Result<IdentityFacts, InputError> readIdentityFacts(const std::string &path)
{
    return withPrivateFile(path, [&](std::string_view text) -> Result<IdentityFacts, InputError> {
        if (isSealed(text))
            return SealedKey::parse(text, path).map([](const SealedKey &key) { return IdentityFacts{key.publicKey, true}; });
        return parseIdentity(text, path, {}).map([](const X25519KeyPair &pair) {
            return IdentityFacts{pair.publicKey, false};
        });
    });
}

static std::string plainText(SecretKind kind, const Key32 &secret)
{
    const std::string_view header = headerOf(kind);
    std::string key = toCheckedBase64(secret.view(), header);
    std::string content;
    content.reserve(512); // growing would leave copies of the key
    content.append(header)
        .append("\n# Keep this file private: anyone who has it can act in your name.\n")
        .append(key)
        .append("\n");
    wipeSecret(key.data(), key.size());
    return content;
}

using WriteFile = Result<void, InputError> (*)(const std::string &path, ByteView content);

static Result<void, InputError> writeText(WriteFile write, const std::string &path, std::string &&text)
{
    auto written = write(path, asBytes(text));
    wipeSecret(text.data(), text.size());
    return written;
}

static Result<void, InputError> write(WriteFile write, const std::string &path, const X25519KeyPair &pair, RandomSource &random,
                                      const Sealing &sealing)
{
    if (!sealing.passphrase)
        return writeText(write, path, plainText(SecretKind::PrivateKey, pair.secret));
    const auto key = SealedKey::seal(pair, *sealing.passphrase, sealing.cost, random);
    if (!key)
        return tl::unexpected(noMemory(path, sealing.cost));
    return writeText(write, path, key->text());
}

Result<void, InputError> writeIdentity(const std::string &path, const X25519KeyPair &pair, RandomSource &random,
                                       const Sealing &sealing)
{
    return write(&createFile, path, pair, random, sealing);
}

Result<void, InputError> rewriteIdentity(const std::string &path, const X25519KeyPair &pair, RandomSource &random,
                                         const Sealing &sealing)
{
    return write(&replaceSecretFile, path, pair, random, sealing);
}

Result<crypto::PublicKey, InputError> writeNewIdentity(const std::string &path, RandomSource &random, const Sealing &sealing)
{
    const X25519KeyPair pair = X25519KeyPair::generate(random);
    if (const auto written = writeIdentity(path, pair, random, sealing); !written)
        return tl::unexpected(written.error());
    return pair.publicKey;
}

Result<Key32, InputError> loadPresharedKey(const std::string &path)
{
    return withPrivateFile(path, [&](std::string_view text) { return parseSecretFile(SecretKind::PresharedKey, text, path); });
}

Result<Key32, InputError> writeNewPresharedKey(const std::string &path, RandomSource &random)
{
    Key32 secret;
    random.fill(secret.mutableView());
    if (const auto written = writeText(&createFile, path, plainText(SecretKind::PresharedKey, secret)); !written)
        return tl::unexpected(written.error());
    return secret;
}

Result<void, InputError> writePresharedKey(const std::string &path, const Key32 &secret)
{
    return writeText(&replaceSecretFile, path, plainText(SecretKind::PresharedKey, secret));
}

} // namespace skyseal::keys
