// Writes JSON text in the order it is given, numbers exactly. QJsonDocument would sort the keys, although
// scripts expect "event" first in every line, turn -0.0 into 0, and make core depend on Qt.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace skyseal {

/// Builds one JSON value. Calls nest as the value does; commas are inserted.
///
///     JsonWriter json;
///     json.beginObject().field("event", "link").field("frames", 12u).endObject();
class JsonWriter
{
public:
    JsonWriter &beginObject();
    JsonWriter &endObject();
    JsonWriter &beginArray();
    JsonWriter &endArray();
    JsonWriter &key(std::string_view name);

    /// Text in UTF-8. Invalid bytes are replaced by U+FFFD, one for each maximal part of a character (the practice that
    /// Unicode recommends), so that strict readers accept the line as well.
    JsonWriter &value(std::string_view text);
    JsonWriter &value(const char *text) { return value(std::string_view(text)); }
    JsonWriter &value(bool flag);
    /// Shortest text that reads back to the same double; "NaN", "Infinity" and "-Infinity" as strings.
    JsonWriter &value(double number);
    /// Shortest text that reads back to the same float.
    JsonWriter &value(float number);
    JsonWriter &value(std::int32_t number) { return value(static_cast<std::int64_t>(number)); }
    JsonWriter &value(std::uint32_t number) { return value(static_cast<std::uint64_t>(number)); }
    JsonWriter &value(std::int64_t number);
    JsonWriter &value(std::uint64_t number);
    JsonWriter &null();

    template<typename T> JsonWriter &field(std::string_view name, const T &content)
    {
        key(name);
        return value(content);
    }

    /// The text written so far; complete once every begin has its end.
    const std::string &text() const { return m_text; }
    void clear();

private:
    void separate();
    void raw(std::string_view token);

    std::string m_text;
    bool m_needsComma = false;
};

} // namespace skyseal
