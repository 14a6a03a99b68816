// The stage in which a state machine of a sweep is, its age, and the end of the patience with it.
#pragma once

#include "core/base/clock.h"

#include <limits>

namespace skyseal::experiment {

/// `Stage`: an enumeration, whose first value is the stage at the beginning. There are two clocks: `now` is the caller's, in
/// seconds; `snapshotTime` is the station's, which was read for a snapshot.
template<typename Stage> class StageTimer
{
public:
    Stage stage() const { return m_stage; }
    bool is(Stage stage) const { return m_stage == stage; }

    void enter(Stage stage, Duration patience, double now, double snapshotTime)
    {
        m_stage = stage;
        m_deadline = now + seconds(patience);
        m_snapshotStart = snapshotTime;
    }
    /// A stage that waits for no other end.
    void enterUnlimited(Stage stage)
    {
        m_stage = stage;
        m_deadline = std::numeric_limits<double>::infinity();
    }

    bool isOverdue(double now) const { return now >= m_deadline; }
    /// Seconds in the stage when the snapshot was taken; negative for one of before.
    double age(double snapshotTime) const { return snapshotTime - m_snapshotStart; }

private:
    Stage m_stage{};
    double m_deadline = std::numeric_limits<double>::infinity();
    double m_snapshotStart = 0;
};

} // namespace skyseal::experiment
