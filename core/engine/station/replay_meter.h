// Counts replayed records that indicate an attack. Networks duplicate datagrams, but do not make more copies than originals
// (see isAttacked()): replays count while they outnumber good records. Fed with counters at a steady pace; no clock.
#pragma once

#include "core/engine/common/loss_meter.h"

#include <utility>

namespace skyseal::engine {

class ReplayMeter
{
public:
    /// Totals of good and of replayed records so far.
    void note(std::uint64_t good, std::uint64_t replayed)
    {
        m_good.note(good);
        m_replayed.note(replayed);
        const std::uint64_t before = std::exchange(m_last, replayed);
        if (m_replayed.value() > m_good.value())
            m_attacking += replayed - before;
    }

    /// Since the start.
    std::uint64_t attacking() const { return m_attacking; }

private:
    Growth<4> m_good, m_replayed;
    std::uint64_t m_last = 0;
    std::uint64_t m_attacking = 0;
};

} // namespace skyseal::engine
