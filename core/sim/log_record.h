// One record of ArduPilot's DataFlash format (LogStructure.h there): A3 95, the type, and the fields without padding, little-
// endian. Every log begins with FMT records, which describe all its types, so that readers need no table of their own.
#pragma once

#include "core/base/byte_writer.h"

#include <array>
#include <bit>
#include <string_view>

namespace skyseal::sim {

/// Layout of a type of record.
struct LogLayout
{
    std::uint8_t type = 0;
    std::string_view name;   ///< at most 4 characters
    std::string_view format; ///< one letter a field: Q uint64, I uint32, H uint16, B and M uint8, f float, c int16 and C uint16
                             ///< in hundredths, L degrees in 1e-7, e int32 in hundredths, N and Z texts of 16 and 64 bytes
    std::string_view columns; ///< names, with commas
};

class LogRecord
{
public:
    static constexpr std::uint8_t kFormatType = 128;

    explicit LogRecord(std::uint8_t type) { put(std::uint16_t(0x95a3)).put(type); }

    template<std::integral T> LogRecord &put(T value)
    {
        ByteWriter(reserve(sizeof(T))).littleEndian(value);
        return *this;
    }
    LogRecord &put(float value) { return put(std::bit_cast<std::uint32_t>(value)); }
    LogRecord &put(double value) { return put(static_cast<float>(value)); }
    /// A text in `size` bytes, cut or filled with zeros.
    LogRecord &text(std::string_view value, std::size_t size)
    {
        const MutableByteView target = reserve(size);
        std::fill(target.begin(), target.end(), std::uint8_t(0));
        std::copy_n(value.begin(), std::min(value.size(), target.size()), target.begin());
        return *this;
    }

    ByteView bytes() const { return ByteView(m_buffer).first(m_size); }

    /// Length of a record of a layout, with its header.
    static std::size_t length(const LogLayout &layout);
    /// The FMT record that describes a layout.
    static LogRecord describe(const LogLayout &layout);

private:
    MutableByteView reserve(std::size_t size)
    {
        const std::size_t at = m_size;
        m_size = std::min(m_size + size, m_buffer.size());
        return MutableByteView(m_buffer).subspan(at, m_size - at);
    }

    std::array<std::uint8_t, 128> m_buffer;
    std::size_t m_size = 0;
};

} // namespace skyseal::sim
