#include "core/crypto/passphrase_box.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/passphrase.h"

#include <sodium.h>

namespace skyseal::crypto {

static_assert(std::tuple_size_v<PassphraseSalt> == crypto_pwhash_argon2id_SALTBYTES);
static_assert(Key32::size() == crypto_aead_chacha20poly1305_ietf_KEYBYTES);
static_assert(std::tuple_size_v<SealedSecret> == 32 + crypto_aead_chacha20poly1305_ietf_ABYTES);

static constexpr std::uint8_t kNonce[crypto_aead_chacha20poly1305_ietf_NPUBBYTES] = {};

bool isAcceptable(const PassphraseCost &cost)
{
    return cost.passes >= kLeastPassphraseCost.passes && cost.passes <= kMostPassphraseCost.passes
        && cost.memoryKiB >= kLeastPassphraseCost.memoryKiB && cost.memoryKiB <= kMostPassphraseCost.memoryKiB;
}

Result<Key32, PassphraseError> keyFromPassphrase(const Passphrase &passphrase, const PassphraseCost &cost,
                                                 const PassphraseSalt &salt)
{
    Key32 key;
    const ByteView bytes = passphrase.view();
    if (!isAcceptable(cost)
        || crypto_pwhash_argon2id(key.mutableView().data(), key.size(), reinterpret_cast<const char *>(bytes.data()),
                                  bytes.size(), salt.data(), cost.passes, std::size_t{cost.memoryKiB} * 1024,
                                  crypto_pwhash_argon2id_ALG_ARGON2ID13)
            != 0)
        return tl::unexpected(PassphraseError::NoMemory);
    return key;
}

Result<SealedSecret, PassphraseError> sealWithPassphrase(const Key32 &secret, const Passphrase &passphrase,
                                                         const PassphraseCost &cost, const PassphraseSalt &salt,
                                                         ByteView associated)
{
    const auto key = keyFromPassphrase(passphrase, cost, salt);
    if (!key)
        return tl::unexpected(key.error());
    SealedSecret out;
    crypto_aead_chacha20poly1305_ietf_encrypt(out.data(), nullptr, secret.view().data(), secret.size(), associated.data(),
                                              associated.size(), nullptr, kNonce, key->view().data());
    return out;
}

Result<Key32, PassphraseError> openWithPassphrase(const SealedSecret &sealed, const Passphrase &passphrase,
                                                  const PassphraseCost &cost, const PassphraseSalt &salt, ByteView associated)
{
    const auto key = keyFromPassphrase(passphrase, cost, salt);
    if (!key)
        return tl::unexpected(key.error());
    Key32 out;
    if (crypto_aead_chacha20poly1305_ietf_decrypt(out.mutableView().data(), nullptr, nullptr, sealed.data(), sealed.size(),
                                                  associated.data(), associated.size(), kNonce, key->view().data())
        != 0)
        return tl::unexpected(PassphraseError::DoesNotOpen);
    return out;
}

} // namespace skyseal::crypto
