// Records by an AEAD whose nonce has 12 bytes and whose tag has 16: checks sizes, makes the nonce, and leaves the algorithm to
// the suite. The format is described in record_cipher.h.
#pragma once

#include "core/crypto/record_keys.h"

#include <concepts>
#include <cstring>
#include <memory>
#include <optional>
#include <span>

namespace skyseal::crypto {

inline constexpr std::size_t kAeadTagLength = 16;
using AeadTag = std::span<std::uint8_t, kAeadTagLength>;

/// An AEAD under one key. `seal` writes a ciphertext as long as the plaintext to `out`, which either starts at the plaintext's
/// address or does not overlap it, and the tag to `tag`. `open` decrypts `body` in place and returns false, without plaintext
/// left in `body`, if the tag is wrong. Both return false if the library fails.
template<typename T>
concept Aead = requires(T aead, const Nonce12 &nonce, ByteView in, std::uint8_t *out, MutableByteView body, AeadTag tag)
{
    {
        aead.ready()
        } -> std::same_as<bool>;
    {
        aead.seal(nonce, in, in, out, tag)
        } -> std::same_as<bool>;
    {
        aead.open(nonce, in, body, tag)
        } -> std::same_as<bool>;
};

template<Aead Algorithm> class AeadRecord final : public RecordCipher
{
public:
    AeadRecord(SuiteId suite, const RecordKeys &keys) : m_suite(suite), m_algorithm(keys.key), m_nonces(keys.iv) {}

    /// A factory for the descriptor of `suite`; null if the library refused the cipher.
    template<SuiteId suite> static std::unique_ptr<RecordCipher> make(const RecordKeys &keys)
    {
        auto cipher = std::make_unique<AeadRecord>(suite, keys);
        return cipher->m_algorithm.ready() ? std::move(cipher) : nullptr;
    }

    SuiteId suite() const override { return m_suite; }

    std::size_t seal(std::uint64_t counter, ByteView associatedData, ByteView plaintext, MutableByteView out) override
    {
        const std::size_t size = plaintext.size();
        if (out.size() < size + kAeadTagLength)
            return 0;
        if (!m_algorithm.seal(m_nonces.at(counter), associatedData, plaintext, out.data(),
                              AeadTag(out.data() + size, kAeadTagLength)))
            return 0;
        return size + kAeadTagLength;
    }

    std::optional<MutableByteView> open(std::uint64_t counter, ByteView associatedData, MutableByteView sealed) override
    {
        if (sealed.size() < kAeadTagLength)
            return std::nullopt;
        const MutableByteView body = sealed.first(sealed.size() - kAeadTagLength);
        const AeadTag tag(body.data() + body.size(), kAeadTagLength);
        return m_algorithm.open(m_nonces.at(counter), associatedData, body, tag) ? std::optional(body) : std::nullopt;
    }

private:
    SuiteId m_suite;
    Algorithm m_algorithm;
    NonceBase m_nonces;
};

} // namespace skyseal::crypto
