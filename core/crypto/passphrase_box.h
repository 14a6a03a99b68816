// A secret of 32 bytes sealed with a passphrase: Argon2id (RFC 9106) makes a key of it, ChaCha20-Poly1305 (RFC 8439) seals
// the secret. The derived key seals this one message and is never used again, since every sealing has a fresh salt;
// therefore the nonce can be zero.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/crypto/passphrase.h"

#include <array>
#include <cstdint>

namespace skyseal::crypto {

/// What one guess costs. More than one lane is not offered: libsodium computes one.
struct PassphraseCost
{
    std::uint32_t passes = 3;
    std::uint32_t memoryKiB = 256 * 1024;

    bool operator==(const PassphraseCost &) const = default;
};

/// What is accepted: below, a stolen file is guessed too quickly; above, a hostile file would stall the reader or eat its
/// memory.
inline constexpr PassphraseCost kLeastPassphraseCost{1, 8 * 1024};
inline constexpr PassphraseCost kMostPassphraseCost{16, 1024 * 1024};
bool isAcceptable(const PassphraseCost &cost);

using PassphraseSalt = std::array<std::uint8_t, 16>;
/// The ciphertext, then its tag.
using SealedSecret = std::array<std::uint8_t, 32 + 16>;

/// NoMemory: this machine cannot give as much as the cost asks for. DoesNotOpen: another passphrase, or something was
/// changed; nobody can tell these apart.
enum class PassphraseError : std::uint8_t { NoMemory, DoesNotOpen };

/// Argon2id with one lane: 32 bytes. DoesNotOpen never.
Result<Key32, PassphraseError> keyFromPassphrase(const Passphrase &passphrase, const PassphraseCost &cost,
                                                 const PassphraseSalt &salt);

/// `associated` is authenticated with it. The cost must be acceptable; the salt must be fresh and random.
Result<SealedSecret, PassphraseError> sealWithPassphrase(const Key32 &secret, const Passphrase &passphrase,
                                                         const PassphraseCost &cost, const PassphraseSalt &salt,
                                                         ByteView associated);
Result<Key32, PassphraseError> openWithPassphrase(const SealedSecret &sealed, const Passphrase &passphrase,
                                                  const PassphraseCost &cost, const PassphraseSalt &salt, ByteView associated);

} // namespace skyseal::crypto
