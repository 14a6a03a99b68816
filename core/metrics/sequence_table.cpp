#include "core/metrics/sequence_table.h"

namespace skyseal::metrics {

std::size_t SequenceTable::Hash::operator()(const Sender &sender) const
{
    const std::size_t place = sender.remote.ip[15] * 65536u + sender.remote.port;
    return (static_cast<std::size_t>(sender.link) * 65536u + sender.system * 256u + sender.component) ^ place << 24;
}

SequenceTable::SequenceTable()
{
    m_trackers.reserve(kMostSenders);
}

void SequenceTable::note(const Sender &sender, std::uint8_t sequence, TimePoint now)
{
    auto found = m_trackers.find(sender);
    if (found == m_trackers.end()) {
        if (m_trackers.size() >= kMostSenders && !makeRoom(now)) {
            ++m_untracked;
            return;
        }
        found = m_trackers.emplace(sender, SequenceTracker()).first;
    }
    found->second.note(sequence, now);
}

bool SequenceTable::makeRoom(TimePoint now)
{
    const auto established = [now](const SequenceTracker &tracker) {
        return tracker.counts().received >= kEstablishedAfter && now - tracker.lastHeard() < kEstablishedFor;
    };
    auto idlest = m_trackers.end();
    for (auto it = m_trackers.begin(); it != m_trackers.end(); ++it) {
        if (!established(it->second) && (idlest == m_trackers.end() || it->second.lastHeard() < idlest->second.lastHeard()))
            idlest = it;
    }
    if (idlest == m_trackers.end())
        return false;
    m_evictedOfSystem[idlest->first.system] += idlest->second.counts();
    m_trackers.erase(idlest);
    ++m_evicted;
    return true;
}

void SequenceTable::expectRestart(const Sender &sender)
{
    if (const auto found = m_trackers.find(sender); found != m_trackers.end())
        found->second.expectRestart();
}

SequenceCounts SequenceTable::counts(const Sender &sender) const
{
    const auto found = m_trackers.find(sender);
    return found == m_trackers.end() ? SequenceCounts() : found->second.counts();
}

SequenceCounts SequenceTable::countsOfSystem(std::uint8_t system) const
{
    SequenceCounts out = m_evictedOfSystem[system];
    for (const auto &[sender, tracker] : m_trackers) {
        if (sender.system == system)
            out += tracker.counts();
    }
    return out;
}

SequenceCounts SequenceTable::total() const
{
    SequenceCounts out;
    for (const SequenceCounts &evicted : m_evictedOfSystem)
        out += evicted;
    for (const auto &[sender, tracker] : m_trackers)
        out += tracker.counts();
    return out;
}

} // namespace skyseal::metrics
