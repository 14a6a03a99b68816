// Shared by the suites: the derivation of their keys from a direction secret, and the nonce of a record.
#pragma once

#include "core/base/secret_bytes.h"
#include "core/crypto/kdf.h"
#include "core/crypto/record_cipher.h"
#include "core/crypto/store_integer.h"

#include <bit>
#include <cstring>
#include <string>

namespace skyseal::crypto {

/// A nonce of 12 bytes. They have room for 16, so that they can be written in one store: libraries read them in overlapping
/// words, which would wait for several pending ones.
class Nonce12
{
public:
    using Words = std::uint64_t __attribute__((vector_size(16)));
    explicit Nonce12(const Words &words) { std::memcpy(m_bytes, &words, sizeof m_bytes); }
    const std::uint8_t *data() const { return m_bytes; }
    static constexpr std::size_t size() { return 12; }

private:
    alignas(16) std::uint8_t m_bytes[sizeof(Words)];
};

/// The keys of a suite, see record_cipher.h. Each suite uses those that it needs, and a prefix of `iv`.
struct RecordKeys
{
    Key32 key;
    Key32 iv;
    Key32 mac;

    /// `framing`: "record", or "inline" (inline_cipher.h).
    static RecordKeys derive(const DirectionSecret &secret, SuiteId suite, std::string_view framing = "record")
    {
        const auto derived = [&](std::string_view use) {
            std::string info("skyseal v1 ");
            info.append(framing).append(" ").append(suiteInfo(suite).name).append(" ").append(use);
            return hkdfExpandKey(secret, asBytes(info));
        };
        return {derived("key"), derived("iv"), derived("mac")};
    }
};

/// The IV of a direction, from which each record's nonce is computed.
class NonceBase
{
public:
    explicit NonceBase(const Key32 &iv) { std::memcpy(m_iv.mutableView().data(), iv.view().data(), 12); }

    /// iv xor (4 zero bytes, counter as 64-bit big-endian).
    Nonce12 at(std::uint64_t counter) const
    {
        Nonce12::Words words;
        std::memcpy(&words, m_iv.view().data(), sizeof words);
        if constexpr (std::endian::native == std::endian::little)
            words ^= Nonce12::Words{__builtin_bswap64(counter >> 32), __builtin_bswap64(counter << 32)};
        else
            words ^= Nonce12::Words{counter >> 32, counter << 32};
        return Nonce12(words);
    }

private:
    SecretBytes<sizeof(Nonce12::Words)> m_iv; ///< padded with zeros
};

/// A cipher under the given keys in place of derived ones; published vectors are checked through it. Null as for
/// makeRecordCipher().
std::unique_ptr<RecordCipher> makeRecordCipherFromKeys(SuiteId suite, RecordKeys &&keys);

} // namespace skyseal::crypto
