#include "core/link/link.h"

namespace skyseal::link {

const char *name(LinkState state)
{
    switch (state) {
    case LinkState::Closed: return "closed";
    case LinkState::Opening: return "opening";
    case LinkState::Listening: return "listening";
    case LinkState::Connected: return "connected";
    case LinkState::Waiting: return "waiting";
    case LinkState::Failed: return "failed";
    case LinkState::Ended: return "ended";
    }
    return "";
}

Link::Link(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options)
    : m_url(std::move(url)), m_traits(m_url.traits()), m_id(id), m_listener(listener), m_options(options)
{}

Link::~Link() = default;

std::string Link::localAddress() const
{
    const std::string text = m_url.toText();
    return text.substr(text.find(':') + 1);
}

void Link::setState(LinkState state, LinkError error)
{
    if (state == m_state && error == m_error)
        return;
    m_state = state;
    m_error = std::move(error);
    Q_EMIT stateChanged(state);
}

} // namespace skyseal::link

#include "moc_link.cpp"
