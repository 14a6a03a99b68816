#include "app/common/mavsec_options.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/mavsec_cipher.h"

namespace skyseal::app {

using crypto::MavsecCipher;

void MavsecOptions::declare(Options &options)
{
    options.addResearchValue("cipher", "NAME", "With mavsec2019: chacha20 or aes-256-ctr.", "chacha20");
    options.addResearchValue(
        "key", "HEX",
        "With mavsec2019: the key, if it is not the published one. Command lines are visible to all users of this "
        "machine; use --key-file for a secret key.");
    options.addResearchValue("key-file", "FILE",
                             "With mavsec2019: file of the key, readable by its owner only: 32 bytes, or 64 hex digits.");
    options.addResearchValue("nonce", "HEX",
                             "With mavsec2019: nonce of ChaCha20 (12 bytes) or first counter block of AES-256-CTR (16).");
    options.addResearchValue("counter", "N", "With mavsec2019: initial block counter of ChaCha20.", "1");
}

MavsecOptions MavsecOptions::read(Options &options)
{
    MavsecOptions out;
    out.m_chosen = options.text("framing") == "mavsec2019";
    if (!out.m_chosen) {
        for (const char *name : {"cipher", "key", "key-file", "nonce", "counter"}) {
            if (options.has(name))
                options.fail(std::string("--") + name + ": only with --framing mavsec2019");
        }
        return out;
    }
    const std::string name = options.text("cipher");
    if (name == crypto::name(MavsecCipher::Kind::Aes256Ctr))
        out.m_settings.kind = MavsecCipher::Kind::Aes256Ctr;
    else if (name != crypto::name(MavsecCipher::Kind::ChaCha20))
        options.fail("--cipher '" + name + "': chacha20 or aes-256-ctr is expected");
    if (out.m_settings.kind == MavsecCipher::Kind::Aes256Ctr && options.has("counter"))
        options.fail("--counter: the counter of AES-256-CTR is part of --nonce");
    out.m_settings.counter = static_cast<std::uint32_t>(options.wholeNumber("counter", 0, UINT32_MAX));
    out.m_settings.keyFile = options.text("key-file");
    out.m_settings.nonceHex = options.text("nonce");
    if (const auto tried = engine::makeMavsecCipher(out.m_settings, Key32()); !tried)
        options.fail("--nonce: " + tried.error().text());
    if (options.has("key")) {
        if (auto key = engine::mavsecKeyFromHex(options.text("key")))
            out.m_key = std::make_shared<const Key32>(std::move(*key));
        else
            options.fail("--key: 64 hex digits are expected");
        if (options.has("key-file"))
            options.fail("--key and --key-file exclude each other");
    }
    return out;
}

Result<MavsecCipher, InputError> MavsecOptions::cipher() const
{
    return cipher(m_settings.kind);
}

Result<MavsecCipher, InputError> MavsecOptions::cipher(crypto::MavsecKind kind) const
{
    engine::MavsecSettings settings = m_settings;
    settings.kind = kind;
    if (kind != m_settings.kind)
        settings.nonceHex.clear(); // it has another length
    return m_key ? engine::makeMavsecCipher(settings, *m_key) : engine::makeMavsecCipher(settings);
}

} // namespace skyseal::app
