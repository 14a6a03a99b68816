// Encrypt-then-MAC in place with a truncated tag, for ciphers that keep the length. Opening verifies the tag before it
// decrypts. The format is described in inline_cipher.h.
#pragma once

#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/inline_cipher.h"

#include <sodium.h>

namespace skyseal::crypto {

template<typename Body> class InlineThenMac final : public InlineCipher
{
public:
    InlineThenMac(SuiteId suite, const RecordKeys &keys) : m_suite(suite), m_body(keys), m_mac(keys.mac) {}

    /// A factory for the descriptor of `suite`; null if the library refused the cipher.
    template<SuiteId suite> static std::unique_ptr<InlineCipher> make(const RecordKeys &keys)
    {
        auto cipher = std::make_unique<InlineThenMac>(suite, keys);
        return cipher->m_body.ready() && cipher->m_mac.ready() ? std::move(cipher) : nullptr;
    }

    SuiteId suite() const override { return m_suite; }

    std::optional<Tag> seal(std::uint64_t counter, ByteView associatedData, MutableByteView body) override
    {
        if (!m_body.encrypt(counter, body, body))
            return std::nullopt;
        return shortTag(counter, associatedData, body);
    }

    bool open(std::uint64_t counter, ByteView associatedData, MutableByteView body, const Tag &tag) override
    {
        const auto right = shortTag(counter, associatedData, body);
        const bool good = right && declassified(sodium_memcmp(right->data(), tag.data(), tag.size())) == 0;
        if (!good)
            return false;
        const bool opened = m_body.decrypt(counter, body).has_value();
        if (!opened)
            sodium_memzero(body.data(), body.size()); // a part of it may be decrypted
        return opened;
    }

private:
    std::optional<Tag> shortTag(std::uint64_t counter, ByteView associatedData, ByteView body)
    {
        const auto whole = m_mac.tag(counter, associatedData, body);
        if (!whole)
            return std::nullopt;
        Tag out;
        std::memcpy(out.data(), whole->data(), out.size());
        return out;
    }

    SuiteId m_suite;
    Body m_body;
    RecordMac m_mac;
};

} // namespace skyseal::crypto
