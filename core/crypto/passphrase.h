// A passphrase as a person typed it, on its way to the key derivation and nowhere else.
#pragma once

#include "core/base/secret_bytes.h"

#include <optional>

namespace skyseal::crypto {

/// 1 to 1024 bytes, taken as they are (no Unicode normalisation). Move-only, wiped when it dies.
class Passphrase
{
public:
    static constexpr std::size_t kMaxLength = 1024;

    /// A copy of the bytes; the caller wipes its own. nullopt when there are none or too many.
    static std::optional<Passphrase> fromBytes(ByteView bytes)
    {
        if (bytes.empty() || bytes.size() > kMaxLength)
            return std::nullopt;
        Passphrase out;
        std::copy(bytes.begin(), bytes.end(), out.m_bytes.mutableView().begin());
        out.m_size = bytes.size();
        return out;
    }

    /// An explicit second copy.
    Passphrase clone() const { return *fromBytes(view()); }
    ByteView view() const { return ByteView(m_bytes.view()).first(m_size); }
    /// In constant time for passphrases of one length; the length is no secret.
    bool equals(const Passphrase &other) const { return m_size == other.m_size && m_bytes.equals(other.m_bytes); }

private:
    Passphrase() = default;

    SecretBytes<kMaxLength> m_bytes;
    std::size_t m_size = 0;
};

} // namespace skyseal::crypto
