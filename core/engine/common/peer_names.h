// The names of the peers behind session ids. Later events of a session carry only its id, while
// reports show the name.
#pragma once

#include "core/channel/events.h"

#include <map>
#include <optional>
#include <string>
#include <variant>

namespace skyseal::engine {

class PeerNames
{
public:
    /// Takes the next event of an engine or endpoint. Call for every event, before of() for its session: a name is kept
    /// up to and including the event that ends the session.
    template<typename... Events> void note(const std::variant<Events...> &event)
    {
        if (m_ended)
            m_names.erase(*m_ended);
        m_ended.reset();
        if (const auto *up = std::get_if<channel::SessionUp>(&event))
            m_names[up->session] = up->peerName;
        else if (const auto *down = std::get_if<channel::SessionDown>(&event))
            m_ended = down->session;
    }

    /// Empty when the session is not known.
    std::string of(channel::SessionId session) const
    {
        const auto found = m_names.find(session);
        return found == m_names.end() ? std::string() : found->second;
    }

private:
    std::map<channel::SessionId, std::string> m_names;
    std::optional<channel::SessionId> m_ended;
};

} // namespace skyseal::engine
