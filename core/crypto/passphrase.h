// A passphrase as the user entered it; used only for the key derivation.
#pragma once

#include "core/base/bytes.h"
#include "core/base/secret_bytes_fwd.h"

#include <memory>
#include <optional>

namespace skyseal::crypto {

/// 1 to 1024 bytes, used unchanged (no Unicode normalization). Move-only, wiped on destruction; empty after a move from it.
class Passphrase
{
public:
    static constexpr std::size_t kMaxLength = 1024;

    /// Copies the bytes; the caller wipes its own copy. nullopt if there are none or too many.
    static std::optional<Passphrase> fromBytes(ByteView bytes);
    Passphrase(Passphrase &&) noexcept;
    Passphrase &operator=(Passphrase &&) noexcept;
    ~Passphrase();

    /// An explicit second copy.
    Passphrase clone() const;
    ByteView view() const;
    /// Constant time for passphrases of equal length; the length is not secret.
    bool equals(const Passphrase &other) const;

private:
    Passphrase();

    std::unique_ptr<SecretBytes<kMaxLength>> m_bytes; ///< in one place, so that a move leaves no copy to wipe
    std::size_t m_size = 0;
};

} // namespace skyseal::crypto
