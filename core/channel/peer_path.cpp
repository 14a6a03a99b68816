#include "core/channel/peer_path.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kMoveInterval = std::chrono::seconds(1);

} // namespace

PeerPath::PeerPath(const Path &path, TimePoint now, Duration trial, bool heard)
    : m_origin(path), m_current(path), m_notified(path), m_moves(kMoveInterval, now), m_trial(trial), m_heard(heard),
      m_heardHere(now)
{}

TimePoint PeerPath::deadline() const
{
    TimePoint due = m_onTrial ? m_heardHere + m_trial : kNever;
    if (m_notified != m_current)
        due = std::min(due, m_moves.next());
    return due;
}

// An authentic record proves where its datagram came from, not that its writer is there: an attacker can keep a record from
// us and deliver it from his own address. Therefore the trial.
void PeerPath::moveTo(const Path &path, TimePoint now, std::uint64_t stamp)
{
    m_heardHere = now;
    if (path == m_former) {
        endTrial();
    } else if (!m_onTrial && path.carrier != Carrier::Serial) { // The former end of a reconnected stream is gone.
        m_onTrial = true;
        // Otherwise an attacker who repeats a first message in the name of another address directs the session's records there.
        if (m_heard)
            m_former = m_current;
    }
    m_heard = true;
    m_trialStamp = stamp;
    m_current = path;
}

void PeerPath::reportSent(const Path &to, std::uint64_t stamp)
{
    if (to != m_current)
        m_trialStamp = stamp;
}

void PeerPath::confirm(const Path &from, std::uint64_t echo)
{
    if (from == m_current && echo > m_trialStamp)
        endTrial();
}

bool PeerPath::handleDeadline(TimePoint now)
{
    if (!m_onTrial || now < m_heardHere + m_trial)
        return true;
    const bool returns = m_former.has_value();
    if (returns)
        m_current = *m_former;
    endTrial();
    return returns;
}

void PeerPath::endTrial()
{
    m_onTrial = false;
    m_former.reset();
}

std::optional<PeerPath::Move> PeerPath::takeMove(TimePoint now)
{
    if (m_notified == m_current || !m_moves.take(now))
        return std::nullopt;
    const Move move{m_notified, m_current};
    m_notified = m_current;
    return move;
}

} // namespace skyseal::channel
