// A passphrase as the user entered it; used only for the key derivation.
#pragma once

#include "core/base/secret_bytes.h"

#include <optional>

namespace skyseal::crypto {

/// 1 to 1024 bytes, used unchanged (no Unicode normalization). Move-only, wiped on destruction.
class Passphrase
{
public:
    static constexpr std::size_t kMaxLength = 1024;

    /// Copies the bytes; the caller wipes its own copy. nullopt if there are none or too many.
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
    /// Constant time for passphrases of equal length; the length is not secret.
    bool equals(const Passphrase &other) const { return m_size == other.m_size && m_bytes.equals(other.m_bytes); }

private:
    Passphrase() = default;

    SecretBytes<kMaxLength> m_bytes;
    std::size_t m_size = 0;
};

} // namespace skyseal::crypto
