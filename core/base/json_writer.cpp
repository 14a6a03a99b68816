#include "core/base/json_writer.h"

#include <charconv>
#include <cmath>
#include <type_traits>

namespace skyseal {

namespace {

template<typename T> void appendNumber(std::string &out, T number)
{
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    out.append(digits, end);
    if constexpr (std::is_floating_point_v<T>) {
        if (number == 0 && std::signbit(number))
            out += ".0"; // many readers take "-0" for the integer 0
    }
}

/// Bytes of the UTF-8 sequence at the start of `text` (RFC 3629: shortest form, no surrogates, up to U+10FFFF); 0 = none.
std::size_t sequenceLength(std::string_view text)
{
    const auto at = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto follows = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xbf) {
        return at(i) >= low && at(i) <= high;
    };
    const unsigned lead = at(0);
    if (lead < 0x80)
        return 1;
    if (lead >= 0xc2 && lead <= 0xdf)
        return follows(1) ? 2 : 0;
    if (lead >= 0xe0 && lead <= 0xef)
        return follows(1, lead == 0xe0 ? 0xa0 : 0x80, lead == 0xed ? 0x9f : 0xbf) && follows(2) ? 3 : 0;
    if (lead >= 0xf0 && lead <= 0xf4)
        return follows(1, lead == 0xf0 ? 0x90 : 0x80, lead == 0xf4 ? 0x8f : 0xbf) && follows(2) && follows(3) ? 4 : 0;
    return 0;
}

void appendEscaped(std::string &out, std::string_view text)
{
    static constexpr char kDigits[] = "0123456789abcdef";
    out.push_back('"');
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80) {
            const std::size_t length = sequenceLength(text.substr(i));
            if (length > 0) {
                out.append(text, i, length);
                i += length - 1;
            } else {
                out += "\\udc";
                out.push_back(kDigits[byte >> 4]);
                out.push_back(kDigits[byte & 15]);
            }
            continue;
        }
        if (c == '"' || c == '\\') {
            out.push_back('\\');
            out.push_back(c);
        } else if (c == '\n') {
            out += "\\n";
        } else if (c == '\t') {
            out += "\\t";
        } else if (byte < 0x20 || byte == 0x7f) {
            out += "\\u00";
            out.push_back(kDigits[byte >> 4]);
            out.push_back(kDigits[byte & 15]);
        } else {
            out.push_back(c);
        }
    }
    out.push_back('"');
}

} // namespace

void JsonWriter::separate()
{
    if (m_needsComma)
        m_text.push_back(',');
    m_needsComma = true;
}

void JsonWriter::raw(std::string_view token)
{
    separate();
    m_text += token;
}

JsonWriter &JsonWriter::beginObject()
{
    raw("{");
    m_needsComma = false;
    return *this;
}

JsonWriter &JsonWriter::endObject()
{
    m_text.push_back('}');
    m_needsComma = true;
    return *this;
}

JsonWriter &JsonWriter::beginArray()
{
    raw("[");
    m_needsComma = false;
    return *this;
}

JsonWriter &JsonWriter::endArray()
{
    m_text.push_back(']');
    m_needsComma = true;
    return *this;
}

JsonWriter &JsonWriter::key(std::string_view name)
{
    separate();
    appendEscaped(m_text, name);
    m_text.push_back(':');
    m_needsComma = false;
    return *this;
}

JsonWriter &JsonWriter::value(std::string_view text)
{
    separate();
    appendEscaped(m_text, text);
    return *this;
}

JsonWriter &JsonWriter::value(bool flag)
{
    raw(flag ? "true" : "false");
    return *this;
}

JsonWriter &JsonWriter::value(double number)
{
    if (std::isnan(number))
        return value("NaN");
    if (std::isinf(number))
        return value(number > 0 ? "Infinity" : "-Infinity");
    separate();
    appendNumber(m_text, number);
    return *this;
}

JsonWriter &JsonWriter::value(float number)
{
    if (!std::isfinite(number))
        return value(static_cast<double>(number));
    separate();
    appendNumber(m_text, number);
    return *this;
}

JsonWriter &JsonWriter::value(std::int64_t number)
{
    separate();
    appendNumber(m_text, number);
    return *this;
}

JsonWriter &JsonWriter::value(std::uint64_t number)
{
    separate();
    appendNumber(m_text, number);
    return *this;
}

JsonWriter &JsonWriter::null()
{
    raw("null");
    return *this;
}

void JsonWriter::clear()
{
    m_text.clear();
    m_needsComma = false;
}

} // namespace skyseal
