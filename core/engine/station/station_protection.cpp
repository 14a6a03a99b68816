// The part of StationCore that carries MAVLink for a while as a measurement wants it, on links that stay open. Both ends
// agree on the framing when a session begins, so sessions that do not fit are ended and begin anew. A session that is lost
// and comes back meanwhile begins with the suite that is measured.
#include "core/engine/station/station_core.h"

#include <utility>

namespace skyseal::engine {

/// What is on its way is no sign that a goodbye was lost.
static constexpr Duration kGoodbyePause = std::chrono::milliseconds(250);

SecureMode StationCore::secureMode() const
{
    if (!m_protection)
        return m_config.secure;
    return *m_protection == Protection::Plain ? SecureMode::Off : SecureMode::Required;
}

channel::Policy StationCore::policy() const
{
    channel::Policy out = m_config.policy;
    if (m_protection)
        out.allowInline = out.preferInline = *m_protection == Protection::Inline;
    return out;
}

void StationCore::setProtection(std::optional<Protection> protection)
{
    const auto kindOf = [](std::optional<Protection> one) { return one.value_or(Protection::Sealed); };
    const bool inlineBefore = policy().allowInline;
    const auto before = std::exchange(m_protection, protection);
    const bool plain = secureMode() == SecureMode::Off;
    const bool other = policy().allowInline != inlineBefore || kindOf(before) != kindOf(protection);
    if (m_channel && isSealing(before) && (plain || other)) {
        m_goodbyes = m_channel->closeAll(steadyNow()); // while this end still speaks so
        m_goodbyeAgain = steadyNow() + kGoodbyePause;
        handleEvents(steadyNow());
    }
    if (m_channel)
        m_channel->endpoint().setPolicy(steadyNow(), policy());
    m_policy.setMode(secureMode());
    m_routes.forgetClear();
    m_links.forEach([this](link::Link &link) { noteRemoteOf(link); });
    m_changed = true;
    finishWake();
}

/// A goodbye goes out once and may be lost. Who goes on sending records has not heard it, and would not speak in clear until
/// the session times out. It is the same datagram again, so that whoever did hear it refuses it as seen.
void StationCore::repeatGoodbye(TimePoint now, const Path &from)
{
    if (now < m_goodbyeAgain)
        return;
    for (const ChannelDriver::Goodbye &goodbye : m_goodbyes) {
        if (goodbye.to == from) {
            m_links.send(goodbye.to, goodbye.datagram);
            m_goodbyeAgain = now + kGoodbyePause;
        }
    }
}

void StationCore::holdSuite(std::optional<crypto::SuiteId> suite)
{
    m_heldSuite = suite;
}

void StationCore::resumeSuite(crypto::SuiteId suite)
{
    m_nextSuite = suite;
    if (m_channel) {
        channel::Endpoint &endpoint = m_channel->endpoint();
        for (const channel::SessionId session : endpoint.sessions()) {
            if (!endpoint.sessionInfo(session)->silent)
                m_nextSuite.reset();
            endpoint.switchSuite(steadyNow(), session, suite);
        }
    }
    finishWake();
}

void StationCore::beginWithSuite(TimePoint now, const channel::SessionUp &up)
{
    const auto next = std::exchange(m_nextSuite, std::nullopt);
    const auto wanted = m_heldSuite ? m_heldSuite : next ? next : m_config.preferredSuite;
    if (wanted && wanted != up.suite)
        m_channel->endpoint().switchSuite(now, up.session, *wanted);
}

} // namespace skyseal::engine
