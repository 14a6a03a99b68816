// A secret of 32 bytes sealed with a passphrase: Argon2id (RFC 9106) derives a key from the passphrase, ChaCha20-Poly1305
// (RFC 8439) seals the secret. Every sealing has a fresh salt, so that a derived key seals one message only; therefore the
// nonce is zero.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/secret_bytes_fwd.h"

#include <array>
#include <cstdint>

namespace skyseal::crypto {

class Passphrase;

/// Cost of one guess. Always one lane: libsodium does not support more.
struct PassphraseCost
{
    std::uint32_t passes = 3;
    std::uint32_t memoryKiB = 256 * 1024;

    bool operator==(const PassphraseCost &) const = default;
};

/// Accepted range: with less, a stolen file can be guessed too quickly; with more, a hostile file could stall the reader or
/// exhaust its memory.
inline constexpr PassphraseCost kLeastPassphraseCost{1, 8 * 1024};
inline constexpr PassphraseCost kMostPassphraseCost{16, 1024 * 1024};
bool isAcceptable(const PassphraseCost &cost);

using PassphraseSalt = std::array<std::uint8_t, 16>;
/// Ciphertext, then tag.
using SealedSecret = std::array<std::uint8_t, 32 + 16>;

/// NoMemory: this machine cannot provide the memory of the cost. DoesNotOpen: wrong passphrase or modified data, which cannot
/// be distinguished.
enum class PassphraseError : std::uint8_t { NoMemory, DoesNotOpen };

/// Argon2id with one lane and 32 bytes of output. Fails only with NoMemory, also for a cost that is not acceptable.
Result<Key32, PassphraseError> keyFromPassphrase(const Passphrase &passphrase, const PassphraseCost &cost,
                                                 const PassphraseSalt &salt);

/// `associated` is authenticated as well. The cost must be acceptable; the salt must be fresh and random.
Result<SealedSecret, PassphraseError> sealWithPassphrase(const Key32 &secret, const Passphrase &passphrase,
                                                         const PassphraseCost &cost, const PassphraseSalt &salt,
                                                         ByteView associated);
Result<Key32, PassphraseError> openWithPassphrase(const SealedSecret &sealed, const Passphrase &passphrase,
                                                  const PassphraseCost &cost, const PassphraseSalt &salt, ByteView associated);

} // namespace skyseal::crypto
