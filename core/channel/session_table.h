// The sessions of an endpoint, found in one step by the connection id of a record and by the number that the owner uses:
// the low byte of both is the slot.
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
        bool up = false; ///< the owner knows of it
        TimePoint since{};
    };

    /// A connection id that no session has, kept for one; nullopt when all slots are taken. `anywhere`: any of the free
    /// ones, for who must not guess it; otherwise in the lowest free slot, which keeps the table short.
    std::optional<ConnectionId> reserve(RandomSource &random, bool anywhere = false);
    void release(ConnectionId connection);
    /// The number of the session that will live under a reserved id.
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
    /// A session with that key that is up; nullptr when there is none.
    Session *upWith(const PublicKey &peer);

    /// The session that is up and whose records come from there, the one heard last of several; nullptr when there is none.
    Entry *upAt(const Path &path);

    /// Calls `visit(Entry &)` for each session; it may erase the one it is called with.
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
    std::size_t m_everTaken = 0; ///< the slots beyond were never used: low ones are taken first
    std::uint32_t m_serial = 0;
};

} // namespace skyseal::channel
