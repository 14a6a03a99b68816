// Writes integers and bytes into a caller's buffer; like in ByteReader, an overflow is sticky and checked once.
#pragma once

#include "core/base/bytes.h"

#include <algorithm>
#include <bit>
#include <concepts>

namespace skyseal {

/// Appends to a caller's buffer. A write past the end writes nothing and makes `ok()` false.
class ByteWriter
{
public:
    explicit ByteWriter(MutableByteView buffer) : m_buffer(buffer) {}

    bool ok() const { return m_ok; }
    std::size_t size() const { return m_size; }
    std::size_t room() const { return m_buffer.size() - m_size; }
    /// The bytes written so far.
    MutableByteView written() const { return m_buffer.first(m_size); }

    template<std::integral T> void littleEndian(T value) { fixed<T, std::endian::little>(value); }
    template<std::integral T> void bigEndian(T value) { fixed<T, std::endian::big>(value); }
    void u8(std::uint8_t value) { littleEndian(value); }
    void u16(std::uint16_t value) { littleEndian(value); }
    void u32(std::uint32_t value) { littleEndian(value); }
    void u64(std::uint64_t value) { littleEndian(value); }

    void bytes(ByteView source)
    {
        const MutableByteView target = reserve(source.size());
        std::copy_n(source.begin(), target.size(), target.begin());
    }

    /// Reserves `count` bytes for the caller to fill; empty if they do not fit.
    MutableByteView reserve(std::size_t count)
    {
        if (!m_ok || room() < count) {
            m_ok = false;
            return {};
        }
        const MutableByteView out = m_buffer.subspan(m_size, count);
        m_size += count;
        return out;
    }

private:
    template<std::integral T, std::endian order> void fixed(T value)
    {
        const MutableByteView out = reserve(sizeof(T));
        const auto bits = static_cast<std::make_unsigned_t<T>>(value);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const std::size_t at = order == std::endian::little ? i : sizeof(T) - 1 - i;
            out[at] = static_cast<std::uint8_t>(bits >> (8 * i));
        }
    }

    MutableByteView m_buffer;
    std::size_t m_size = 0;
    bool m_ok = true;
};

} // namespace skyseal
