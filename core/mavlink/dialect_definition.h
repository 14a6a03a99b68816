// A dialect as its XML files define it, with owned names; made by dialect_xml, turned into tables by the generator and into
// a Dialect at run time.
#pragma once

#include "core/mavlink/message_info.h"

#include <optional>
#include <string>
#include <vector>

namespace skyseal::mavlink {

struct FieldDefinition
{
    std::string name;
    FieldType type{};
    std::uint8_t arrayLength = 0;
    bool extension = false;
    bool isMavlinkVersion = false;
    std::string enumName, units, printFormat;
    std::vector<std::uint64_t> unknown; ///< as in FieldInfo
    std::uint8_t offset = 0;            ///< by layOut()

    std::size_t size() const { return sizeOf(type) * (arrayLength ? arrayLength : 1u); }
};

struct MessageDefinition
{
    std::uint32_t id = 0;
    std::string name;
    std::vector<FieldDefinition> fields; ///< in the order of the definition
    std::string file;
    std::size_t line = 0;

    // by layOut()
    std::uint8_t crcExtra = 0, minLength = 0, maxLength = 0;
    std::int16_t targetSystemOffset = -1, targetComponentOffset = -1;
};

struct EnumEntryDefinition
{
    std::uint64_t value = 0;
    std::string name;
    bool hasLocation = true; ///< of MAV_CMD: parameters 5 to 7 are a place. The schema's default.
};

struct EnumDefinition
{
    std::string name;
    bool bitmask = false;
    std::vector<EnumEntryDefinition> entries;
};

struct DialectDefinition
{
    std::vector<MessageDefinition> messages; ///< by rising id
    std::vector<EnumDefinition> enums;       ///< by name, entries by rising value
};

/// Fills offsets, lengths and CRC_EXTRA: fields ordered by element size, largest first, equal sizes in the order of the
/// definition, extensions after them, unsorted (https://mavlink.io/en/guide/serialization.html). Returns false if the
/// payload exceeds 255 bytes.
bool layOut(MessageDefinition &message);

} // namespace skyseal::mavlink
