#include "core/mavlink/message_text.h"

namespace skyseal::mavlink {

namespace {

std::string quoted(std::string_view text)
{
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (byte < 0x20 || byte >= 0x7f) {
            out += "\\x";
            out += kDigits[byte >> 4];
            out += kDigits[byte & 15];
        } else {
            out += c;
        }
    }
    return out + '"';
}

/// The names of the bits that are set; the rest as one number.
std::string bitNames(const EnumInfo &definition, std::uint64_t bits)
{
    std::string out;
    std::uint64_t left = bits;
    for (const EnumEntry &entry : definition.entries) {
        if (entry.value == 0 || (left & entry.value) != entry.value)
            continue;
        out += (out.empty() ? "" : "|") + std::string(entry.name);
        left &= ~entry.value;
    }
    if (left || out.empty())
        out += (out.empty() ? "" : "|") + std::to_string(left);
    return out;
}

std::string valueText(FieldValue value, const FieldInfo &field, const EnumInfo *definition)
{
    if (definition && !value.isFloating()) {
        if (definition->bitmask)
            return bitNames(*definition, value.bits());
        if (const std::string_view name = definition->nameOf(value.bits()); !name.empty())
            return std::string(name);
    }
    return toText(value) + (field.units.empty() ? "" : " " + std::string(field.units));
}

} // namespace

std::string fieldText(const Frame &frame, const FieldInfo &field, const Dialect &dialect)
{
    if (field.type == FieldType::Char)
        return quoted(fieldText(frame.payload(), field));
    const EnumInfo *definition = field.enumName.empty() ? nullptr : dialect.enumeration(field.enumName);
    if (field.arrayLength == 0)
        return valueText(fieldValue(frame.payload(), field), field, definition);
    std::string out = "[";
    for (std::size_t i = 0; i < field.elements(); ++i)
        out += (i ? ", " : "") + valueText(fieldValue(frame.payload(), field, i), field, definition);
    return out + "]";
}

std::string messageText(const Frame &frame, const Dialect &dialect)
{
    std::string out = std::to_string(frame.systemId()) + "/" + std::to_string(frame.componentId()) + " ";
    out += frame.info().name;
    for (const FieldInfo &field : frame.info().fields)
        out += " " + std::string(field.name) + "=" + fieldText(frame, field, dialect);
    return out;
}

} // namespace skyseal::mavlink
