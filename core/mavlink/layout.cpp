#include "core/mavlink/crc.h"
#include "core/mavlink/dialect_definition.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace skyseal::mavlink {

namespace {

constexpr std::array<std::string_view, 11> kTypeNames{"char",    "uint8_t",  "int8_t",  "uint16_t", "int16_t", "uint32_t",
                                                      "int32_t", "uint64_t", "int64_t", "float",    "double"};

void add(std::uint16_t &crc, std::string_view text)
{
    crc = crcAccumulate(crc, {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()});
}

/// CRC_EXTRA: the checksum of the message's name and of its fields on the wire, extensions left out.
std::uint8_t crcExtra(const MessageDefinition &message, const std::vector<const FieldDefinition *> &wireOrder)
{
    std::uint16_t crc = kCrcStart;
    add(crc, message.name);
    add(crc, " ");
    for (const FieldDefinition *field : wireOrder) {
        add(crc, nameOf(field->type));
        add(crc, " ");
        add(crc, field->name);
        add(crc, " ");
        if (field->arrayLength)
            crc = crcAccumulate(crc, {&field->arrayLength, 1});
    }
    return static_cast<std::uint8_t>((crc & 0xff) ^ (crc >> 8));
}

} // namespace

std::string_view nameOf(FieldType type)
{
    return kTypeNames[static_cast<std::size_t>(type)];
}

bool layOut(MessageDefinition &message)
{
    std::vector<FieldDefinition *> wireOrder;
    for (FieldDefinition &field : message.fields) {
        if (!field.extension)
            wireOrder.push_back(&field);
    }
    std::stable_sort(wireOrder.begin(), wireOrder.end(),
                     [](const FieldDefinition *a, const FieldDefinition *b) { return sizeOf(a->type) > sizeOf(b->type); });
    message.crcExtra = crcExtra(message, {wireOrder.begin(), wireOrder.end()});
    const std::size_t base = wireOrder.size();
    for (FieldDefinition &field : message.fields) {
        if (field.extension)
            wireOrder.push_back(&field);
    }

    std::size_t offset = 0;
    message.minLength = 0;
    for (std::size_t i = 0; i < wireOrder.size(); ++i) {
        FieldDefinition &field = *wireOrder[i];
        if (offset + field.size() > 255)
            return false;
        field.offset = static_cast<std::uint8_t>(offset);
        offset += field.size();
        if (i + 1 == base)
            message.minLength = static_cast<std::uint8_t>(offset);
        // MANUAL_CONTROL calls its target system just "target".
        const bool single = field.type == FieldType::Uint8 && field.arrayLength == 0;
        if (single && (field.name == "target_system" || (field.name == "target" && message.name == "MANUAL_CONTROL")))
            message.targetSystemOffset = field.offset;
        if (single && field.name == "target_component")
            message.targetComponentOffset = field.offset;
    }
    message.maxLength = static_cast<std::uint8_t>(offset);
    return true;
}

} // namespace skyseal::mavlink
