// One element of a field of any type: access for the inspector, the decoder and user dialects to fields without a
// generated struct.
#pragma once

#include "core/base/bytes.h"
#include "core/mavlink/message_info.h"

#include <bit>
#include <optional>
#include <string>
#include <string_view>

namespace skyseal::mavlink {

/// A value and its type, kept bit for bit: a NaN keeps its payload, and a value that was read can be written back unchanged.
class FieldValue
{
public:
    FieldValue() = default;
    static FieldValue fromBits(FieldType type, std::uint64_t bits) { return FieldValue(type, bits); }
    /// The nearest value of `type`: clamped to its range, rounded towards zero; NaN becomes 0 for whole numbers.
    static FieldValue fromNumber(FieldType type, double number);

    FieldType type() const { return m_type; }
    bool isFloating() const { return m_type == FieldType::Float || m_type == FieldType::Double; }
    bool isSigned() const;
    /// As many low bits as the type has, zeros above.
    std::uint64_t bits() const { return m_bits; }

    float asFloat() const { return std::bit_cast<float>(static_cast<std::uint32_t>(m_bits)); } ///< of a Float
    double asDouble() const;                            ///< any type; 64-bit integers lose their low bits
    std::int64_t asSigned() const;                      ///< of an integer, sign extended
    std::uint64_t asUnsigned() const { return m_bits; } ///< of an unsigned integer or a char

    bool operator==(const FieldValue &) const = default;

private:
    FieldValue(FieldType type, std::uint64_t bits) : m_type(type), m_bits(bits) {}

    FieldType m_type = FieldType::Uint8;
    std::uint64_t m_bits = 0;
};

/// Element `index` (0 for a single value) of a field. Bytes that the payload does not have read as zero, as MAVLink 2 trims
/// them. `index` must be below field.elements().
FieldValue fieldValue(ByteView payload, const FieldInfo &field, std::size_t index = 0);

/// Writes element `index`. Returns false, and writes nothing, if the types differ, there is no such element or no room for it.
bool setFieldValue(MutableByteView payload, const FieldInfo &field, std::size_t index, FieldValue value);

/// False for NaN and for the values of `unknown` (FieldInfo::unknown), by which an element of a field says "not known".
bool isKnown(FieldValue value, std::span<const std::uint64_t> unknown);

/// The bytes of a char array without the zeros at its end; a view into the payload. It may contain any
/// bytes, including zeros.
std::string_view fieldText(ByteView payload, const FieldInfo &field);

/// Fills a char array, the rest with zeros. Returns false if the field is not one, the text is too long or the payload too
/// short.
bool setFieldText(MutableByteView payload, const FieldInfo &field, std::string_view text);

/// A value in the user's notation: "-3", "0x1f", "2.5", "NaN", "Infinity", or for a char one character; nullopt if it is
/// not of that type or out of range.
std::optional<FieldValue> parseFieldValue(FieldType type, std::string_view text);

/// Shortest text that parseFieldValue reads back to the same value (every NaN becomes "NaN").
std::string toText(FieldValue value);

} // namespace skyseal::mavlink
