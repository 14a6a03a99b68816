// Encrypt-then-MAC around an unauthenticated cipher: HMAC-SHA-256 over counter, associated data and ciphertext. Opening
// verifies the tag before it decrypts. The format is described in record_cipher.h.
#pragma once

#include "core/base/declassified.h"
#include "core/crypto/hmac_sha256.h"
#include "core/crypto/record_keys.h"

#include <sodium.h>

#include <algorithm>
#include <concepts>
#include <cstring>

namespace skyseal::crypto {

/// A cipher that turns `n` bytes of plaintext into `bodySize(n)` bytes of ciphertext. `out` of `encrypt` either starts at
/// the plaintext's address or does not overlap it; `decrypt` works in place and returns the plaintext's length.
template<typename T>
concept BodyCipher = requires(T cipher, std::uint64_t counter, ByteView in, MutableByteView out, std::size_t n)
{
    {
        T::bodySize(n)
        } -> std::same_as<std::size_t>;
    {
        T::capacity(n)
        } -> std::same_as<std::optional<std::size_t>>;
    {
        cipher.ready()
        } -> std::same_as<bool>;
    {
        cipher.encrypt(counter, in, out)
        } -> std::same_as<bool>;
    {
        cipher.decrypt(counter, out)
        } -> std::same_as<std::optional<std::size_t>>;
};

/// For ciphers whose ciphertext is as long as the plaintext.
struct SameLength
{
    static std::size_t bodySize(std::size_t n) { return n; }
    static std::optional<std::size_t> capacity(std::size_t room) { return room; }
};

/// The tag of a record.
class RecordMac
{
public:
    static constexpr std::size_t kLength = 16;
    using Tag = std::array<std::uint8_t, kLength>;

    explicit RecordMac(const Key32 &key) : m_hmac(key.view()) {}

    bool ready() const { return m_hmac.ready(); }

    /// nullopt if the library fails.
    std::optional<Tag> tag(std::uint64_t counter, ByteView associatedData, ByteView ciphertext)
    {
        std::array<std::uint8_t, 12> head;
        storeLittleEndian64(head.data(), counter);
        storeLittleEndian32(head.data() + sizeof counter, static_cast<std::uint32_t>(associatedData.size()));
        Tag out;
        return m_hmac.compute(out, {head, associatedData, ciphertext}) ? std::optional(out) : std::nullopt;
    }

private:
    HmacSha256 m_hmac;
};

template<BodyCipher Body> class EncryptThenMac final : public RecordCipher
{
public:
    EncryptThenMac(SuiteId suite, const RecordKeys &keys) : m_suite(suite), m_body(keys), m_mac(keys.mac) {}

    /// A factory for the descriptor of `suite`; null if the library refused the cipher.
    template<SuiteId suite> static std::unique_ptr<RecordCipher> make(const RecordKeys &keys)
    {
        auto cipher = std::make_unique<EncryptThenMac>(suite, keys);
        return cipher->m_body.ready() && cipher->m_mac.ready() ? std::move(cipher) : nullptr;
    }

    SuiteId suite() const override { return m_suite; }
    std::size_t sealedSize(std::size_t plaintextSize) const override
    {
        return Body::bodySize(plaintextSize) + RecordMac::kLength;
    }
    std::optional<std::size_t> plaintextCapacity(std::size_t room) const override
    {
        return room < RecordMac::kLength ? std::nullopt : Body::capacity(room - RecordMac::kLength);
    }

    std::size_t seal(std::uint64_t counter, ByteView associatedData, ByteView plaintext, MutableByteView out) override
    {
        const std::size_t bodySize = Body::bodySize(plaintext.size());
        if (out.size() < bodySize + RecordMac::kLength)
            return 0;
        const MutableByteView body = out.first(bodySize);
        if (!m_body.encrypt(counter, plaintext, body))
            return 0;
        const auto tag = m_mac.tag(counter, associatedData, body);
        if (!tag)
            return 0;
        std::memcpy(out.data() + bodySize, tag->data(), tag->size());
        return bodySize + RecordMac::kLength;
    }

    std::optional<MutableByteView> open(std::uint64_t counter, ByteView associatedData, MutableByteView sealed) override
    {
        if (sealed.size() < RecordMac::kLength)
            return std::nullopt;
        const MutableByteView body = sealed.first(sealed.size() - RecordMac::kLength);
        const auto tag = m_mac.tag(counter, associatedData, body);
        if (!tag || declassified(crypto_verify_16(tag->data(), body.data() + body.size())) != 0)
            return std::nullopt;
        const std::optional<std::size_t> length = m_body.decrypt(counter, body);
        if (!length) {
            sodium_memzero(body.data(), body.size()); // a part of it may be decrypted
            return std::nullopt;
        }
        return body.first(*length);
    }

private:
    SuiteId m_suite;
    Body m_body;
    RecordMac m_mac;
};

} // namespace skyseal::crypto
