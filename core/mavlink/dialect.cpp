#include "core/mavlink/dialect.h"

#include "core/mavlink/builtin_tables.h"

#include <algorithm>
#include <deque>

namespace skyseal::mavlink {

struct Dialect::Storage
{
    std::shared_ptr<const Storage> base; // the tables that this one extends
    DialectDefinition definition;
    std::deque<std::vector<FieldInfo>> fields;
    std::deque<std::vector<EnumEntry>> entries;
};

Dialect::Dialect(std::vector<MessageInfo> messages, std::vector<EnumInfo> enums, std::shared_ptr<const Storage> storage)
    : m_messages(std::move(messages)), m_enums(std::move(enums)), m_storage(std::move(storage))
{
    std::sort(m_messages.begin(), m_messages.end(), [](const MessageInfo &a, const MessageInfo &b) { return a.id < b.id; });
    std::sort(m_enums.begin(), m_enums.end(), [](const EnumInfo &a, const EnumInfo &b) { return a.name < b.name; });
    std::size_t size = 64;
    while (size < m_messages.size() * 2)
        size *= 2;
    m_mask = size - 1;
    m_slots.assign(size, kEmpty);
    for (std::size_t i = 0; i < m_messages.size(); ++i) {
        std::size_t slot = slotOf(m_messages[i].id);
        while (m_slots[slot] != kEmpty)
            slot = (slot + 1) & m_mask;
        m_slots[slot] = static_cast<std::uint16_t>(i);
    }
}

const Dialect &Dialect::builtin()
{
    static const Dialect dialect = [] {
        const auto messages = builtin::messages();
        const auto enums = builtin::enums();
        return Dialect({messages.begin(), messages.end()}, {enums.begin(), enums.end()}, nullptr);
    }();
    return dialect;
}

Result<Dialect, InputError> Dialect::extended(const DialectDefinition &more) const
{
    auto storage = std::make_shared<Storage>();
    storage->base = m_storage;
    storage->definition = more;
    std::vector<MessageInfo> allMessages = m_messages;
    std::vector<EnumInfo> allEnums = m_enums;

    for (const MessageDefinition &message : storage->definition.messages) {
        if (const MessageInfo *known = find(message.id)) {
            if (known->crcExtra == message.crcExtra && known->name == message.name)
                continue;
            return tl::unexpected(InputError{"message id " + std::to_string(message.id) + " (" + message.name + ") is already "
                                                 + std::string(known->name) + " with another layout",
                                             message.file, message.line});
        }
        if (find(message.name))
            return tl::unexpected(InputError{"a message named " + message.name + " is already known under another id",
                                             message.file, message.line});
        if (allMessages.size() >= kEmpty)
            return tl::unexpected(InputError{"more than 65534 messages", message.file, message.line});
        std::vector<FieldInfo> &fields = storage->fields.emplace_back();
        for (const FieldDefinition &field : message.fields) {
            fields.push_back({field.name, field.type, field.arrayLength, field.offset, field.extension, field.isMavlinkVersion,
                              field.enumName, field.units, field.printFormat, field.unknown});
        }
        allMessages.push_back({message.id, message.name, message.crcExtra, message.minLength, message.maxLength,
                               message.targetSystemOffset, message.targetComponentOffset, fields});
    }

    for (const EnumDefinition &definition : storage->definition.enums) {
        const auto known = std::find_if(allEnums.begin(), allEnums.end(),
                                        [&](const EnumInfo &e) { return e.name == definition.name; });
        std::vector<EnumEntry> &entries = storage->entries.emplace_back();
        if (known != allEnums.end())
            entries.assign(known->entries.begin(), known->entries.end());
        for (const EnumEntryDefinition &entry : definition.entries) {
            const bool present = std::any_of(entries.begin(), entries.end(),
                                             [&](const EnumEntry &e) { return e.value == entry.value; });
            if (!present)
                entries.push_back({entry.value, entry.name});
        }
        std::sort(entries.begin(), entries.end(), [](const EnumEntry &a, const EnumEntry &b) { return a.value < b.value; });
        const EnumInfo merged{definition.name, definition.bitmask, entries};
        if (known != allEnums.end())
            *known = merged;
        else
            allEnums.push_back(merged);
    }
    return Dialect(std::move(allMessages), std::move(allEnums), std::move(storage));
}

const MessageInfo *Dialect::find(std::string_view name) const
{
    const auto it = std::find_if(m_messages.begin(), m_messages.end(), [name](const MessageInfo &m) { return m.name == name; });
    return it == m_messages.end() ? nullptr : &*it;
}

const EnumInfo *Dialect::enumeration(std::string_view name) const
{
    const auto it = std::lower_bound(m_enums.begin(), m_enums.end(), name,
                                     [](const EnumInfo &e, std::string_view n) { return e.name < n; });
    return it == m_enums.end() || it->name != name ? nullptr : &*it;
}

} // namespace skyseal::mavlink
