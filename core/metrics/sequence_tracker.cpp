#include "core/metrics/sequence_tracker.h"

#include <algorithm>

namespace skyseal::metrics {

SequenceCounts &SequenceCounts::operator+=(const SequenceCounts &other)
{
    received += other.received;
    lost += other.lost;
    late += other.late;
    duplicate += other.duplicate;
    restarts += other.restarts;
    return *this;
}

SequenceTracker::Verdict SequenceTracker::note(std::uint8_t sequence, TimePoint now)
{
    const bool silent = m_known && now - m_lastTime > kLongestSilence;
    m_lastTime = now;
    ++m_counts.received;
    if (!m_known)
        return begin(sequence, now);
    const unsigned step = static_cast<std::uint8_t>(sequence - m_newest);
    if (silent && step != 1) {
        ++m_counts.restarts;
        begin(sequence, now);
        return Verdict::Restarted;
    }
    return step == 0 || step > 255 - windowAt(now) ? behind(sequence, (256 - step) % 256, now) : ahead(sequence, step, now);
}

unsigned SequenceTracker::windowAt(TimePoint now) const
{
    const auto passed = std::chrono::duration_cast<std::chrono::milliseconds>(now - m_newestTime).count();
    return static_cast<unsigned>(std::clamp<std::int64_t>(kWindow - passed, kShortWindow, kWindow));
}

SequenceTracker::Verdict SequenceTracker::begin(std::uint8_t sequence, TimePoint now)
{
    m_known = true;
    m_newest = sequence;
    m_newestTime = now;
    m_missing.reset();
    m_before.set();
    m_inRun = false;
    return Verdict::First;
}

SequenceTracker::Verdict SequenceTracker::ahead(std::uint8_t sequence, unsigned step, TimePoint now)
{
    // The previous newest number becomes bit step − 1 (received); the numbers between are missing.
    m_missing <<= step;
    m_before <<= step;
    for (unsigned k = 0; k + 1 < step && k < kWindow; ++k)
        m_missing.set(k);
    m_counts.lost += step - 1;
    m_newest = sequence;
    m_newestTime = now;
    m_inRun = false;
    return step == 1 ? Verdict::InOrder : Verdict::AfterGap;
}

SequenceTracker::Verdict SequenceTracker::behind(std::uint8_t sequence, unsigned back, TimePoint now)
{
    if (!m_inRun || sequence != m_runNext) {
        m_inRun = true;
        m_runDuplicates = 0;
        m_beforeRun = m_counts;
        --m_beforeRun.received;
    }
    m_runNext = static_cast<std::uint8_t>(sequence + 1);
    if (back == 0 || (!m_missing.test(back - 1) && !m_before.test(back - 1))) {
        ++m_counts.duplicate;
        // Duplicates arrive singly between new frames; a whole run of them means that the sender restarted.
        return ++m_runDuplicates == kRestartRun ? restarted(sequence, now) : Verdict::Duplicate;
    }
    if (m_missing.test(back - 1))
        --m_counts.lost;
    m_missing.reset(back - 1);
    m_before.reset(back - 1);
    ++m_counts.late;
    return Verdict::Late;
}

SequenceTracker::Verdict SequenceTracker::restarted(std::uint8_t sequence, TimePoint now)
{
    const std::uint64_t received = m_counts.received;
    m_counts = m_beforeRun;
    m_counts.received = received;
    ++m_counts.restarts;
    begin(sequence, now);
    return Verdict::Restarted;
}

} // namespace skyseal::metrics
