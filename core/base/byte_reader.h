// The cursor through which untrusted bytes are read. Every read is checked; a read past the end makes the error sticky.
#pragma once

#include "core/base/bytes.h"

#include <bit>
#include <concepts>
#include <cstring>

namespace skyseal {

/// Reads from the front of a view. After a read past the end, `ok()` is false, every further read returns zeros, and the
/// position stays: callers check once, at the end of a structure.
class ByteReader
{
public:
    explicit ByteReader(ByteView bytes) : m_bytes(bytes) {}

    bool ok() const { return m_ok; }
    std::size_t position() const { return m_position; }
    std::size_t remaining() const { return m_bytes.size() - m_position; }
    bool atEnd() const { return remaining() == 0; }

    template<std::integral T> T littleEndian() { return fixed<T, std::endian::little>(); }
    template<std::integral T> T bigEndian() { return fixed<T, std::endian::big>(); }
    std::uint8_t u8() { return littleEndian<std::uint8_t>(); }
    std::uint16_t u16() { return littleEndian<std::uint16_t>(); }
    std::uint32_t u32() { return littleEndian<std::uint32_t>(); }
    std::uint64_t u64() { return littleEndian<std::uint64_t>(); }

    /// The next `count` bytes; an empty view if there are fewer.
    ByteView bytes(std::size_t count)
    {
        if (!m_ok || remaining() < count) {
            m_ok = false;
            return {};
        }
        const ByteView out = m_bytes.subspan(m_position, count);
        m_position += count;
        return out;
    }

    ByteView rest() { return bytes(remaining()); }

private:
    template<std::integral T, std::endian order> T fixed()
    {
        const ByteView raw = bytes(sizeof(T));
        if (raw.empty())
            return T{};
        std::make_unsigned_t<T> value = 0;
        for (std::size_t i = 0; i < sizeof(T); ++i) {
            const std::size_t at = order == std::endian::little ? sizeof(T) - 1 - i : i;
            value = static_cast<std::make_unsigned_t<T>>((sizeof(T) > 1 ? value << 8 : 0) | raw[at]);
        }
        return static_cast<T>(value);
    }

    ByteView m_bytes;
    std::size_t m_position = 0;
    bool m_ok = true;
};

} // namespace skyseal
