// The messages and enums that a program knows. The built-in ones are constant tables made at build time; further ones can
// be read from XML at run time.
#pragma once

#include "core/mavlink/dialect_definition.h"
#include "core/mavlink/message_info.h"

#include "core/base/result.h"

#include <memory>
#include <span>
#include <vector>

namespace skyseal::mavlink {

class Dialect
{
public:
    /// ardupilotmega with its includes.
    static const Dialect &builtin();

    /// This dialect and further definitions. A known message must have the same id, name and CRC_EXTRA;
    /// enums are merged. The error's source and line are those of the definition.
    Result<Dialect, InputError> extended(const DialectDefinition &more) const;

    /// The message with this id; null when unknown. No allocation, usually a single probe.
    const MessageInfo *find(std::uint32_t id) const
    {
        for (std::size_t slot = slotOf(id);; slot = (slot + 1) & m_mask) {
            const std::uint16_t index = m_slots[slot];
            if (index == kEmpty)
                return nullptr;
            if (m_messages[index].id == id)
                return &m_messages[index];
        }
    }
    const MessageInfo *find(std::string_view name) const;
    const EnumInfo *enumeration(std::string_view name) const;

    std::span<const MessageInfo> messages() const { return m_messages; } ///< by rising id
    std::span<const EnumInfo> enums() const { return m_enums; }          ///< by name

private:
    struct Storage; // names and tables of the definitions that were read at run time

    static constexpr std::uint16_t kEmpty = 0xffff;

    Dialect(std::vector<MessageInfo> messages, std::vector<EnumInfo> enums, std::shared_ptr<const Storage> storage);
    std::size_t slotOf(std::uint32_t id) const { return (id * 2654435761u >> 16) & m_mask; }

    std::vector<MessageInfo> m_messages;
    std::vector<EnumInfo> m_enums;
    std::shared_ptr<const Storage> m_storage;
    std::vector<std::uint16_t> m_slots; ///< open addressing, at most half full
    std::size_t m_mask = 0;
};

} // namespace skyseal::mavlink
