#include "core/mavlink/message_json.h"

#include "core/base/hex.h"
#include "core/base/utf8.h"
#include "core/mavlink/field_value.h"

#include <array>
#include <charconv>
#include <cmath>

namespace skyseal::mavlink {

namespace {

bool isUnusualNan(FieldValue value)
{
    if (!value.isFloating() || !std::isnan(value.asDouble()))
        return false;
    return value.bits() != (value.type() == FieldType::Float ? 0x7fc00000u : 0x7ff8000000000000u);
}

std::string hexBits(FieldValue value)
{
    std::string out(2 * sizeOf(value.type()), '0');
    for (std::size_t i = 0; i < out.size(); ++i)
        out[out.size() - 1 - i] = "0123456789abcdef"[(value.bits() >> (4 * i)) & 15];
    return out;
}

void writeValue(JsonWriter &json, FieldValue value)
{
    switch (value.type()) {
    case FieldType::Float: json.value(value.asFloat()); break;
    case FieldType::Double: json.value(value.asDouble()); break;
    case FieldType::Uint64:
    case FieldType::Int64: json.value(std::string_view(toText(value))); break;
    default: json.value(value.isSigned() ? value.asSigned() : static_cast<std::int64_t>(value.asUnsigned()));
    }
}

/// True if the frame can hold the field. MAVLink 1 has no trimming: a missing field was not sent.
bool carries(const Frame &frame, const FieldInfo &field)
{
    return frame.version() == 2 || !field.extension || field.offset < frame.payload().size();
}

void writeUnusualNans(JsonWriter &json, const Frame &frame)
{
    bool begun = false;
    for (const FieldInfo &field : frame.info().fields) {
        bool named = false;
        for (std::size_t i = 0; i < field.elements() && carries(frame, field); ++i) {
            const FieldValue value = fieldValue(frame.payload(), field, i);
            if (!isUnusualNan(value))
                continue;
            if (!begun)
                json.key("nan_bits").beginObject();
            if (!named)
                json.key(field.name).beginObject();
            begun = named = true;
            json.field(std::to_string(i), std::string_view(hexBits(value)));
        }
        if (named)
            json.endObject();
    }
    if (begun)
        json.endObject();
}

void writeBytesThatAreNoText(JsonWriter &json, const Frame &frame)
{
    bool begun = false;
    for (const FieldInfo &field : frame.info().fields) {
        if (field.type != FieldType::Char || !carries(frame, field))
            continue;
        const std::string_view text = fieldText(frame.payload(), field);
        if (isUtf8(text))
            continue;
        if (!begun)
            json.key("text_bytes").beginObject();
        begun = true;
        json.field(field.name, std::string_view(toHex(asBytes(text))));
    }
    if (begun)
        json.endObject();
}

} // namespace

void writeMessageJson(JsonWriter &json, const Frame &frame, std::optional<WallTime> time)
{
    json.beginObject().field("event", "message").field("id", frame.messageId()).field("name", frame.info().name);
    json.field("version", frame.version()).field("sysid", std::uint32_t(frame.systemId()));
    json.field("compid", std::uint32_t(frame.componentId())).field("seq", std::uint32_t(frame.sequence()));
    json.field("signed", frame.isSigned());
    json.key("fields").beginObject();
    for (const FieldInfo &field : frame.info().fields) {
        if (!carries(frame, field))
            continue;
        json.key(field.name);
        if (field.type == FieldType::Char) {
            json.value(fieldText(frame.payload(), field));
        } else if (field.arrayLength == 0) {
            writeValue(json, fieldValue(frame.payload(), field));
        } else {
            json.beginArray();
            for (std::size_t i = 0; i < field.elements(); ++i)
                writeValue(json, fieldValue(frame.payload(), field, i));
            json.endArray();
        }
    }
    json.endObject();
    writeUnusualNans(json, frame);
    writeBytesThatAreNoText(json, frame);
    if (time)
        json.field("time_usec", std::string_view(std::to_string(time->time_since_epoch().count())));
    json.endObject();
}

void writeBadJson(JsonWriter &json, FrameFault fault, std::uint64_t offset, std::uint64_t length)
{
    json.beginObject().field("event", "bad").field("reason", nameOf(fault)).field("offset", offset).field("length", length);
    json.endObject();
}

} // namespace skyseal::mavlink
