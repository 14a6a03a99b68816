// The stage of a sweep that is carried out, its age, and the end of the patience with it.
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <limits>

namespace skyseal::experiment {

enum class SweepStage : std::uint8_t {
    Idle,
    Closing,
    Connecting,
    Settling,
    Flying, ///< to the phase of the next runs
    Switching,
    WarmingUp,
    Beginning, ///< the first probe of the run is requested
    Measuring,
    Ending, ///< the last probe of the run is requested
    Landing,
    Restoring
};

/// There are two clocks: `now` is the caller's, in seconds; `snapshotTime` is the station's, which was read for a snapshot.
class StageTimer
{
public:
    SweepStage stage() const { return m_stage; }
    bool is(SweepStage stage) const { return m_stage == stage; }

    void enter(SweepStage stage, Duration patience, double now, double snapshotTime)
    {
        m_stage = stage;
        m_deadline = now + seconds(patience);
        m_snapshotStart = snapshotTime;
    }
    /// A stage that waits for no other end.
    void enterUnlimited(SweepStage stage)
    {
        m_stage = stage;
        m_deadline = std::numeric_limits<double>::infinity();
    }

    bool isOverdue(double now) const { return now >= m_deadline; }
    /// Seconds in the stage when the snapshot was taken; negative for one of before.
    double age(double snapshotTime) const { return snapshotTime - m_snapshotStart; }

private:
    SweepStage m_stage = SweepStage::Idle;
    double m_deadline = std::numeric_limits<double>::infinity();
    double m_snapshotStart = 0;
};

} // namespace skyseal::experiment
