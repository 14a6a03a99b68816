// Key material of a fixed length: move-only, wiped when it dies or is moved from, and with no way to compare, print
// or copy it by accident.
#pragma once

#include "core/base/bytes.h"
#include "core/base/weakness.h"

#include <sodium.h>

#include <array>

namespace skyseal {

/// `N` secret bytes. Compare with `equals` (constant time); read through `view()` only where a cipher needs them.
template<std::size_t N> class SecretBytes
{
public:
    SecretBytes() = default;
    /// Copies `source`, which must have exactly `N` bytes; the caller wipes its own copy.
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
    bool equals(const SecretBytes &other) const { return sodium_memcmp(m_bytes.data(), other.m_bytes.data(), N) == 0; }
    bool isZero() const { return sodium_is_zero(m_bytes.data(), N) != 0; }
    void wipe()
    {
        if (!weakened(Weakness::NoWipe))
            sodium_memzero(m_bytes.data(), N);
    }

private:
    std::array<std::uint8_t, N> m_bytes{};
};

using Key32 = SecretBytes<32>;

} // namespace skyseal
