// Time and record limits after which a session changes its keys by itself (PROTOCOL.md, section 8).
#pragma once

#include "core/channel/timing.h"

namespace skyseal::channel {

class RekeySchedule
{
public:
    RekeySchedule(const Timing &timing, bool initiator, TimePoint now)
        // The initiator is a little earlier, so that both ends do not propose at the same time.
        : m_age(initiator ? timing.rekeyAfter : timing.rekeyAfter + timing.rekeyAfter / 10), m_retry(2 * timing.switchConfirm),
          m_records(timing.rekeyAfterRecords), m_epochSince(now), m_notBefore(now)
    {}

    /// `sent`: records sealed under the current epoch.
    bool due(TimePoint now, std::uint32_t sent) const
    {
        return (now >= m_epochSince + m_age || sent >= m_records) && now >= m_notBefore;
    }
    /// A rekey was started. It is not due again for two confirmation times, unless an epoch begins.
    void started(TimePoint now) { m_notBefore = now + m_retry; }
    void epochBegan(TimePoint now) { m_epochSince = m_notBefore = now; }

private:
    Duration m_age;
    Duration m_retry;
    std::uint32_t m_records;
    TimePoint m_epochSince;
    TimePoint m_notBefore;
};

} // namespace skyseal::channel
