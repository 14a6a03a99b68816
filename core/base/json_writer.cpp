#include "core/base/json_writer.h"

#include "core/base/printable.h"
#include "core/base/utf8.h"

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
            out += ".0"; // many readers parse "-0" as the integer 0
    }
}

void appendCodeUnit(std::string &out, unsigned unit)
{
    static constexpr char kDigits[] = "0123456789abcdef";
    out += "\\u";
    for (const int shift : {12, 8, 4, 0})
        out.push_back(kDigits[unit >> shift & 15]);
}

/// \uXXXX, in two parts beyond U+FFFF.
void appendEscape(std::string &out, char32_t character)
{
    if (character <= 0xffff)
        return appendCodeUnit(out, character);
    appendCodeUnit(out, 0xd800 + ((character - 0x10000) >> 10));
    appendCodeUnit(out, 0xdc00 + (character & 0x3ff));
}

/// Control and format characters are escaped, so that a line is safe on a terminal.
void appendEscaped(std::string &out, std::string_view text)
{
    out.push_back('"');
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80) {
            const Utf8Character character = firstCharacter(text.substr(i));
            if (!character.valid)
                out += kReplacementCharacter;
            else if (isUnprintable(character.value))
                appendEscape(out, character.value);
            else
                out += text.substr(i, character.length);
            i += character.length - 1;
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
            appendEscape(out, byte);
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
