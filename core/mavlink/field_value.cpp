#include "core/mavlink/field_value.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace skyseal::mavlink {

namespace {

/// Range of each integer type, in two's complement.
struct Range
{
    std::int64_t lowest = 0;
    std::uint64_t highest = 0;
};

bool signedType(FieldType type)
{
    return type == FieldType::Int8 || type == FieldType::Int16 || type == FieldType::Int32 || type == FieldType::Int64;
}

Range rangeOf(FieldType type)
{
    const unsigned bits = static_cast<unsigned>(8 * sizeOf(type));
    if (signedType(type))
        return {-static_cast<std::int64_t>((std::uint64_t(1) << (bits - 1)) - 1) - 1, (std::uint64_t(1) << (bits - 1)) - 1};
    return {0, ~std::uint64_t(0) >> (64 - bits)};
}

std::uint64_t maskOf(FieldType type)
{
    return ~std::uint64_t(0) >> (64 - 8 * sizeOf(type));
}

FieldValue fromFloating(FieldType type, double number)
{
    if (type == FieldType::Float)
        return FieldValue::fromBits(type, std::bit_cast<std::uint32_t>(static_cast<float>(number)));
    return FieldValue::fromBits(type, std::bit_cast<std::uint64_t>(number));
}

template<typename T> std::optional<T> parseAll(std::string_view text, auto... format)
{
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, format...);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<FieldValue> parseWhole(FieldType type, std::string_view text)
{
    const bool negative = text.starts_with('-');
    if (negative)
        text.remove_prefix(1);
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    const auto magnitude = parseAll<std::uint64_t>(hex ? text.substr(2) : text, hex ? 16 : 10);
    const Range range = rangeOf(type);
    const std::uint64_t limit = negative ? std::uint64_t(0) - static_cast<std::uint64_t>(range.lowest) : range.highest;
    if (!magnitude || *magnitude > limit)
        return std::nullopt;
    return FieldValue::fromBits(type, (negative ? std::uint64_t(0) - *magnitude : *magnitude) & maskOf(type));
}

} // namespace

FieldValue FieldValue::fromNumber(FieldType type, double number)
{
    if (type == FieldType::Float || type == FieldType::Double)
        return fromFloating(type, number);
    const Range range = rangeOf(type);
    if (std::isnan(number))
        return fromBits(type, 0);
    if (number <= static_cast<double>(range.lowest))
        return fromBits(type, static_cast<std::uint64_t>(range.lowest) & maskOf(type));
    if (number >= static_cast<double>(range.highest))
        return fromBits(type, range.highest);
    const auto whole = number < 0 ? static_cast<std::uint64_t>(static_cast<std::int64_t>(number))
                                  : static_cast<std::uint64_t>(number);
    return fromBits(type, whole & maskOf(type));
}

bool FieldValue::isSigned() const
{
    return signedType(m_type);
}

std::int64_t FieldValue::asSigned() const
{
    const unsigned unused = static_cast<unsigned>(64 - 8 * sizeOf(m_type));
    return isSigned() ? static_cast<std::int64_t>(m_bits << unused) >> unused : static_cast<std::int64_t>(m_bits);
}

double FieldValue::asDouble() const
{
    if (m_type == FieldType::Float)
        return static_cast<double>(asFloat());
    if (m_type == FieldType::Double)
        return std::bit_cast<double>(m_bits);
    return isSigned() ? static_cast<double>(asSigned()) : static_cast<double>(m_bits);
}

FieldValue fieldValue(ByteView payload, const FieldInfo &field, std::size_t index)
{
    const std::size_t size = sizeOf(field.type);
    const std::size_t begin = field.offset + index * size;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size && begin + i < payload.size(); ++i)
        bits |= std::uint64_t(payload[begin + i]) << (8 * i);
    return FieldValue::fromBits(field.type, bits);
}

bool setFieldValue(MutableByteView payload, const FieldInfo &field, std::size_t index, FieldValue value)
{
    const std::size_t size = sizeOf(field.type);
    const std::size_t begin = field.offset + index * size;
    if (value.type() != field.type || index >= field.elements() || begin + size > payload.size())
        return false;
    for (std::size_t i = 0; i < size; ++i)
        payload[begin + i] = static_cast<std::uint8_t>(value.bits() >> (8 * i));
    return true;
}

bool isKnown(FieldValue value, std::span<const std::uint64_t> unknown)
{
    if (value.isFloating() && std::isnan(value.asDouble()))
        return false;
    return std::find(unknown.begin(), unknown.end(), value.bits()) == unknown.end();
}

std::string_view fieldText(ByteView payload, const FieldInfo &field)
{
    const std::size_t begin = std::min<std::size_t>(field.offset, payload.size());
    std::string_view text = asText(payload.subspan(begin, std::min(field.size(), payload.size() - begin)));
    while (text.ends_with('\0'))
        text.remove_suffix(1);
    return text;
}

bool setFieldText(MutableByteView payload, const FieldInfo &field, std::string_view text)
{
    if (field.type != FieldType::Char || text.size() > field.size() || field.offset + field.size() > payload.size())
        return false;
    const MutableByteView target = payload.subspan(field.offset, field.size());
    std::fill(target.begin(), target.end(), std::uint8_t(0));
    std::copy(text.begin(), text.end(), target.begin());
    return true;
}

std::optional<FieldValue> parseFieldValue(FieldType type, std::string_view text)
{
    if (type == FieldType::Char) {
        if (text.size() > 1)
            return std::nullopt;
        return FieldValue::fromBits(type, text.empty() ? 0 : static_cast<std::uint8_t>(text.front()));
    }
    if (type != FieldType::Float && type != FieldType::Double)
        return parseWhole(type, text);
    if (text == "NaN")
        return fromFloating(type, std::numeric_limits<double>::quiet_NaN());
    if (text == "Infinity" || text == "-Infinity")
        return fromFloating(type, text.front() == '-' ? -HUGE_VAL : HUGE_VAL);
    if (type == FieldType::Float) {
        const auto number = parseAll<float>(text, std::chars_format::general);
        return number && std::isfinite(*number) ? std::optional(fromFloating(type, static_cast<double>(*number)))
                                                : std::nullopt;
    }
    const auto number = parseAll<double>(text, std::chars_format::general);
    return number && std::isfinite(*number) ? std::optional(fromFloating(type, *number)) : std::nullopt;
}

std::string toText(FieldValue value)
{
    if (value.type() == FieldType::Char)
        return value.bits() ? std::string(1, static_cast<char>(value.bits())) : std::string();
    if (!value.isFloating())
        return value.isSigned() ? std::to_string(value.asSigned()) : std::to_string(value.asUnsigned());
    const double number = value.asDouble();
    if (std::isnan(number))
        return "NaN";
    if (std::isinf(number))
        return number > 0 ? "Infinity" : "-Infinity";
    return value.type() == FieldType::Float ? numberText(value.asFloat()) : numberText(number);
}

} // namespace skyseal::mavlink
