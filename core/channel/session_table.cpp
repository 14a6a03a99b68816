#include "core/channel/session_table.h"

#include <algorithm>

namespace skyseal::channel {

std::optional<ConnectionId> SessionTable::reserve(RandomSource &random, bool anywhere)
{
    std::uint8_t start = 0;
    if (anywhere)
        random.fill({&start, 1});
    for (std::size_t tried = 0; tried < kSlots; ++tried) {
        const std::size_t i = (start + tried) % kSlots;
        Slot &slot = m_slots[i];
        if (slot.taken)
            continue;
        // The high byte differs from that of the slot's last session, so that late records do not reach the new one.
        std::uint8_t high = 0;
        random.fill({&high, 1});
        if (high == static_cast<std::uint16_t>(slot.connection) >> 8)
            ++high;
        slot.connection = static_cast<ConnectionId>(high << 8 | static_cast<int>(i));
        slot.taken = true;
        m_everTaken = std::max(m_everTaken, i + 1);
        return slot.connection;
    }
    return std::nullopt;
}

void SessionTable::release(ConnectionId connection)
{
    m_slots[static_cast<std::uint16_t>(connection) % kSlots].taken = false;
}

SessionId SessionTable::number(ConnectionId connection)
{
    return SessionId{++m_serial << 8 | (static_cast<std::uint16_t>(connection) % static_cast<std::uint32_t>(kSlots))};
}

SessionTable::Entry &SessionTable::put(std::unique_ptr<Session> session, bool up, TimePoint now)
{
    Entry &entry = m_slots[static_cast<std::uint16_t>(session->connection()) % kSlots].entry;
    entry = Entry{std::move(session), up, now};
    return entry;
}

void SessionTable::erase(SessionId session)
{
    if (Entry *entry = find(session)) {
        release(entry->session->connection());
        *entry = {};
    }
}

Session *SessionTable::upWith(const PublicKey &peer)
{
    Session *found = nullptr;
    forEach([&](Entry &entry) {
        if (entry.up && entry.session->peer().key == peer)
            found = entry.session.get();
    });
    return found;
}

SessionTable::Entry *SessionTable::upAt(const Path &path)
{
    Entry *found = nullptr;
    forEach([&](Entry &entry) {
        const bool here = entry.up && entry.session->path() == path;
        if (here && (!found || entry.session->lastReceived() > found->session->lastReceived()))
            found = &entry;
    });
    return found;
}

} // namespace skyseal::channel
