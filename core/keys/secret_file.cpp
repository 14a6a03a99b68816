#include "core/keys/secret_file.h"

#include "core/keys/checked_base64.h"
#include "core/keys/file_io.h"

namespace skyseal::keys {

static constexpr std::string_view kAnyHeader = "skyseal-";

static std::string_view headerOf(SecretKind kind)
{
    return kind == SecretKind::PrivateKey ? "skyseal-private-key-v1" : "skyseal-preshared-key-v1";
}

static std::string_view takeLine(std::string_view &text)
{
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return line;
}

/// Errors never quote what the file holds below its first line: it may be a key.
Result<Key32, InputError> parseSecretFile(SecretKind kind, std::string_view text, const std::string &source)
{
    const std::string_view header = takeLine(text);
    const std::string expected(headerOf(kind));
    if (header != expected) {
        if (header.starts_with(kAnyHeader) && header.size() < 40)
            return tl::unexpected(fileError(source, "holds \"" + std::string(header) + "\", not \"" + expected + "\"", 1));
        return tl::unexpected(fileError(source, "is not a key file of Skyseal: it does not begin with \"" + expected + "\"", 1));
    }
    std::optional<Key32> secret;
    for (std::size_t line = 2; !text.empty(); ++line) {
        const std::string_view content = takeLine(text);
        if (content.empty() || content.starts_with('#'))
            continue;
        if (secret)
            return tl::unexpected(fileError(source, "has more than one key", line));
        if (content.size() < kCheckedBase64Length)
            return tl::unexpected(fileError(source, "has a truncated key", line));
        secret = fromCheckedBase64(content, expected);
        if (!secret)
            return tl::unexpected(fileError(source, "has a damaged key: its check does not fit", line));
    }
    if (!secret)
        return tl::unexpected(fileError(source, "is truncated: it has no key"));
    return std::move(*secret);
}

static Result<Key32, InputError> load(SecretKind kind, const std::string &path)
{
    auto content = readFile(path, FileAccess::Private);
    if (!content)
        return tl::unexpected(content.error());
    auto secret = parseSecretFile(kind, asText(*content), path);
    sodium_memzero(content->data(), content->size());
    return secret;
}

static Result<Key32, InputError> writeNew(SecretKind kind, const std::string &path, RandomSource &random)
{
    Key32 secret;
    random.fill(secret.mutableView());
    const std::string_view header = headerOf(kind);
    std::string key = toCheckedBase64(secret.view(), header);
    std::string content;
    content.reserve(512);
    content.append(header).append("\n# Keep this file to yourself: who has it can speak in your name.\n").append(key).append("\n");
    const auto created = createFile(path, asBytes(content));
    sodium_memzero(key.data(), key.size());
    sodium_memzero(content.data(), content.size());
    if (!created)
        return tl::unexpected(created.error());
    return secret;
}

Result<crypto::X25519KeyPair, InputError> loadIdentity(const std::string &path)
{
    return load(SecretKind::PrivateKey, path).map([](Key32 &&secret) { return crypto::X25519KeyPair::fromSecret(std::move(secret)); });
}

Result<crypto::X25519KeyPair, InputError> writeNewIdentity(const std::string &path, RandomSource &random)
{
    return writeNew(SecretKind::PrivateKey, path, random).map([](Key32 &&secret) {
        return crypto::X25519KeyPair::fromSecret(std::move(secret));
    });
}

Result<Key32, InputError> loadPresharedKey(const std::string &path)
{
    return load(SecretKind::PresharedKey, path);
}

Result<Key32, InputError> writeNewPresharedKey(const std::string &path, RandomSource &random)
{
    return writeNew(SecretKind::PresharedKey, path, random);
}

} // namespace skyseal::keys
