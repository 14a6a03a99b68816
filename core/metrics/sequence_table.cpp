#include "core/metrics/sequence_table.h"

namespace skyseal::metrics {

std::size_t SequenceTable::Hash::operator()(const Sender &sender) const
{
    return static_cast<std::size_t>(sender.link) * 65536u + sender.system * 256u + sender.component;
}

SequenceTable::SequenceTable()
{
    m_trackers.reserve(64);
}

void SequenceTable::note(const Sender &sender, std::uint8_t sequence, TimePoint now)
{
    auto found = m_trackers.find(sender);
    if (found == m_trackers.end()) {
        if (m_trackers.size() >= kMostSenders) {
            ++m_untracked;
            return;
        }
        found = m_trackers.emplace(sender, SequenceTracker()).first;
    }
    found->second.note(sequence, now);
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
    SequenceCounts out;
    for (const auto &[sender, tracker] : m_trackers) {
        if (sender.system == system)
            out += tracker.counts();
    }
    return out;
}

SequenceCounts SequenceTable::countsOfLink(LinkId link) const
{
    SequenceCounts out;
    for (const auto &[sender, tracker] : m_trackers) {
        if (sender.link == link)
            out += tracker.counts();
    }
    return out;
}

SequenceCounts SequenceTable::total() const
{
    SequenceCounts out;
    for (const auto &[sender, tracker] : m_trackers)
        out += tracker.counts();
    return out;
}

} // namespace skyseal::metrics
