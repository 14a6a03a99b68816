// Key material of a fixed length: move-only, wiped on destruction and when moved from, and without operators that would
// compare, print or copy it by accident.
#pragma once

#include "core/base/bytes.h"
#include "core/base/secret_bytes_fwd.h"

#include <algorithm>
#include <array>

namespace skyseal {

/// Overwrites `size` bytes; the compiler cannot remove the call as dead code.
void wipeSecret(void *bytes, std::size_t size) noexcept;
inline void wipeSecret(MutableByteView bytes) noexcept
{
    wipeSecret(bytes.data(), bytes.size());
}
/// Compares in constant time.
[[nodiscard]] bool equalSecrets(const void *a, const void *b, std::size_t size) noexcept;
/// True if all bytes are zero; in constant time.
[[nodiscard]] bool isZeroSecret(const void *bytes, std::size_t size) noexcept;

/// `N` secret bytes. Compare with `equals` (constant time); read `view()` only where a cipher needs the bytes.
template<std::size_t N> class SecretBytes
{
public:
    SecretBytes() = default;
    /// Copies `source`; the caller wipes its own copy.
    explicit SecretBytes(std::span<const std::uint8_t, N> source) { std::copy(source.begin(), source.end(), m_bytes.begin()); }
    ~SecretBytes() { wipe(); }

    SecretBytes(const SecretBytes &) = delete;
    SecretBytes &operator=(const SecretBytes &) = delete;
    SecretBytes(SecretBytes &&other) noexcept : m_bytes(other.m_bytes) { other.wipe(); }
    SecretBytes &operator=(SecretBytes &&other) noexcept
    {
        if (this != &other) {
            m_bytes = other.m_bytes;
            other.wipe();
        }
        return *this;
    }

    static constexpr std::size_t size() { return N; }
    std::span<const std::uint8_t, N> view() const { return std::span<const std::uint8_t, N>(m_bytes); }
    std::span<std::uint8_t, N> mutableView() { return std::span<std::uint8_t, N>(m_bytes); }

    /// An explicit second copy, for the few places where a protocol needs the same secret twice.
    SecretBytes clone() const { return SecretBytes(view()); }
    bool equals(const SecretBytes &other) const { return equalSecrets(m_bytes.data(), other.m_bytes.data(), N); }
    bool isZero() const { return isZeroSecret(m_bytes.data(), N); }
    void wipe() noexcept { wipeSecret(m_bytes.data(), N); }

private:
    std::array<std::uint8_t, N> m_bytes{};
};

} // namespace skyseal
