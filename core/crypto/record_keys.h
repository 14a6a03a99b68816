// Shared by the suites: the derivation of their keys from a direction secret, and the nonce of a record.
#pragma once

#include "core/crypto/kdf.h"
#include "core/crypto/record_cipher.h"
#include "core/crypto/store_integer.h"

#include <array>
#include <cstring>
#include <string>

namespace skyseal::crypto {

using Nonce12 = std::array<std::uint8_t, 12>;

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
    explicit NonceBase(const Key32 &iv) : m_iv(iv.view().first<12>()) {}

    /// iv xor (4 zero bytes, counter as 64-bit big-endian).
    Nonce12 at(std::uint64_t counter) const
    {
        Nonce12 nonce;
        std::uint64_t number = 0;
        std::uint64_t low = 0;
        storeBigEndian64(reinterpret_cast<std::uint8_t *>(&number), counter);
        std::memcpy(&low, m_iv.view().data() + 4, sizeof low);
        low ^= number;
        std::memcpy(nonce.data(), m_iv.view().data(), 4);
        std::memcpy(nonce.data() + 4, &low, sizeof low);
        return nonce;
    }

private:
    SecretBytes<12> m_iv;
};

/// A cipher under the given keys in place of derived ones; published vectors are checked through it. Null as for
/// makeRecordCipher().
std::unique_ptr<RecordCipher> makeRecordCipherFromKeys(SuiteId suite, RecordKeys &&keys);

} // namespace skyseal::crypto
