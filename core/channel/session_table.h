// The sessions of an endpoint. The low byte of a connection id and of a SessionId is the slot, so that both lookups take
// constant time.
#pragma once

#include "core/channel/session.h"

#include <array>
#include <memory>

namespace skyseal::channel {

class SessionTable
{
public:
    static constexpr std::size_t kSlots = 256;

    struct Entry
    {
        std::unique_ptr<Session> session;
        bool up = false; ///< the owner was notified of it
        TimePoint since{};
    };

    /// Reserves a connection id that no session has; nullopt if all slots are taken. `anywhere`: an unpredictable slot, for ids
    /// that an attacker must not guess; otherwise the lowest free slot, which keeps the table short.
    std::optional<ConnectionId> reserve(RandomSource &random, bool anywhere = false);
    void release(ConnectionId connection);
    /// Makes the SessionId of a session with a reserved connection id.
    SessionId number(ConnectionId connection);
    Entry &put(std::unique_ptr<Session> session, bool up, TimePoint now);
    void erase(SessionId session);

    Entry *find(ConnectionId connection)
    {
        Slot &slot = m_slots[static_cast<std::uint16_t>(connection) % kSlots];
        return slot.entry.session && slot.connection == connection ? &slot.entry : nullptr;
    }
    Entry *find(SessionId session)
    {
        Slot &slot = m_slots[static_cast<std::uint32_t>(session) % kSlots];
        return slot.entry.session && slot.entry.session->id() == session ? &slot.entry : nullptr;
    }
    /// Returns the session with this peer that is up, nullptr if there is none.
    Session *upWith(const PublicKey &peer);

    /// Returns the session on this path that is up, the most recently heard of several; nullptr if there is none.
    Entry *upAt(const Path &path);

    /// Calls `visit(Entry &)` for each session. It may erase the session that it is called with.
    template<typename Visit> void forEach(Visit visit)
    {
        for (std::size_t i = 0; i < m_everTaken; ++i) {
            if (m_slots[i].entry.session)
                visit(m_slots[i].entry);
        }
    }

private:
    struct Slot
    {
        Entry entry;
        ConnectionId connection{};
        bool taken = false;
    };

    std::array<Slot, kSlots> m_slots;
    std::size_t m_everTaken = 0; ///< slots from here on were never used
    std::uint32_t m_serial = 0;
};

} // namespace skyseal::channel
