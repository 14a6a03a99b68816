#include "core/engine/station/refusal_log.h"

#include "core/link/address_text.h"

#include <utility>

namespace skyseal::engine {

template<typename Refused> std::optional<Refused> RefusalLog::Counter<Refused>::take(TimePoint now)
{
    if (!isDue(now))
        return std::nullopt;
    notified = now;
    return std::exchange(pending, {});
}

void RefusalLog::refusePlaintext(std::uint8_t systemId, const Address &from)
{
    m_plaintext.count(systemId);
    m_plaintextFrom = from;
}

void RefusalLog::refuseSystem(std::uint8_t systemId, channel::SessionId session)
{
    m_systems.count(systemId);
    m_session = session;
}

std::optional<channel::SessionId> RefusalLog::unnamedSession() const
{
    return m_systems.pending.frames > 0 ? std::optional(m_session) : std::nullopt;
}

void RefusalLog::namePeer(std::string peer, std::string owner)
{
    m_systems.pending.peer = std::move(peer);
    m_systems.pending.owner = std::move(owner);
}

std::optional<PlaintextRefused> RefusalLog::takePlaintext(TimePoint now)
{
    auto out = m_plaintext.take(now);
    if (out)
        out->remoteAddress = link::toText(m_plaintextFrom);
    return out;
}

std::optional<SystemRefused> RefusalLog::takeSystem(TimePoint now)
{
    return m_systems.take(now);
}

} // namespace skyseal::engine
