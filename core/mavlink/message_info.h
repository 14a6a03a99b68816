// Description of messages by a dialect: names, fields and their places on the wire. Tables of these are generated at
// build time, and read from XML at run time; views point into these tables, which live as long as the dialect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace skyseal::mavlink {

enum class FieldType : std::uint8_t { Char, Uint8, Int8, Uint16, Int16, Uint32, Int32, Uint64, Int64, Float, Double };

/// Bytes of one element.
constexpr std::size_t sizeOf(FieldType type)
{
    constexpr std::uint8_t kSizes[] = {1, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

/// The name in the definitions: "uint16_t".
std::string_view nameOf(FieldType type);

struct FieldInfo
{
    std::string_view name;
    FieldType type{};
    std::uint8_t arrayLength = 0; ///< 0 = a single value
    std::uint8_t offset = 0;      ///< in the payload
    bool extension = false;
    bool isMavlinkVersion = false; ///< filled by the sender's library, always 3
    std::string_view enumName{};
    std::string_view units{};
    std::string_view printFormat{};
    std::span<const std::uint64_t> unknown{}; ///< bits of the values by which an element says "not known"; NaN always does

    std::size_t elements() const { return arrayLength ? arrayLength : 1; }
    std::size_t size() const { return elements() * sizeOf(type); }
};

struct MessageInfo
{
    std::uint32_t id = 0;
    std::string_view name;
    std::uint8_t crcExtra = 0;
    std::uint8_t minLength = 0; ///< without extensions
    std::uint8_t maxLength = 0;
    std::int16_t targetSystemOffset = -1; ///< -1: has none
    std::int16_t targetComponentOffset = -1;
    std::span<const FieldInfo> fields; ///< in the order of the definition

    const FieldInfo *field(std::string_view fieldName) const
    {
        for (const FieldInfo &candidate : fields) {
            if (candidate.name == fieldName)
                return &candidate;
        }
        return nullptr;
    }
};

struct EnumEntry
{
    std::uint64_t value = 0;
    std::string_view name;
};

struct EnumInfo
{
    std::string_view name;
    bool bitmask = false;
    std::span<const EnumEntry> entries; ///< by rising value

    /// The entry's name; empty when there is none.
    std::string_view nameOf(std::uint64_t value) const
    {
        for (const EnumEntry &entry : entries) {
            if (entry.value == value)
                return entry.name;
        }
        return {};
    }
};

} // namespace skyseal::mavlink
