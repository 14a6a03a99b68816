// What the suites share: the derivation of their keys from a direction secret, and the nonce of a record.
#pragma once

#include "core/crypto/kdf.h"
#include "core/crypto/record_cipher.h"

#include <array>
#include <string>

namespace skyseal::crypto {

using Nonce12 = std::array<std::uint8_t, 12>;

/// Fills `out` with K(use), see record_cipher.h.
inline void deriveRecordKey(MutableByteView out, const DirectionSecret &secret, SuiteId suite, std::string_view use)
{
    std::string info("skyseal v1 record ");
    info.append(suiteInfo(suite).name).append(" ").append(use);
    static_cast<void>(hkdfExpandSha256(out, secret.view(), asBytes(info)));
}

inline Key32 deriveRecordKey(const DirectionSecret &secret, SuiteId suite, std::string_view use)
{
    Key32 key;
    deriveRecordKey(key.mutableView(), secret, suite, use);
    return key;
}

inline void storeBigEndian64(std::uint8_t *out, std::uint64_t value)
{
    for (int i = 0; i < 8; ++i)
        out[i] = static_cast<std::uint8_t>(value >> (56 - 8 * i));
}

/// The IV of a direction, from which each record's nonce is made.
class NonceBase
{
public:
    NonceBase(const DirectionSecret &secret, SuiteId suite) { deriveRecordKey(m_iv.mutableView(), secret, suite, "iv"); }

    /// iv xor (4 zero bytes, counter as 64-bit big-endian).
    Nonce12 at(std::uint64_t counter) const
    {
        Nonce12 nonce;
        nonce.fill(0);
        storeBigEndian64(nonce.data() + 4, counter);
        for (std::size_t i = 0; i < nonce.size(); ++i)
            nonce[i] = static_cast<std::uint8_t>(nonce[i] ^ m_iv.view()[i]);
        return nonce;
    }

private:
    SecretBytes<12> m_iv;
};

} // namespace skyseal::crypto
