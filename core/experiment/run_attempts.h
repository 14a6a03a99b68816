// How often a run is measured. One whose load is not what its name says is repeated, but not again and again on a machine that
// cannot make the load. After too many failed runs in a row the link counts as lost.
#pragma once

namespace skyseal::experiment {

class RunAttempts
{
public:
    static constexpr unsigned kMost = 3;           ///< of a run
    static constexpr unsigned kMostFailedRuns = 3; ///< in a row

    /// A block of runs has one load, under one condition.
    void beginRun(bool isFirstOfBlock)
    {
        m_count = 1;
        m_isHopeless = m_isHopeless && !isFirstOfBlock;
    }
    /// Once, if no attempt of the run before in this block was valid.
    bool mayRepeat() const { return m_count < (m_isHopeless ? 1 : kMost); }
    void repeat() { ++m_count; }
    unsigned count() const { return m_count; }

    void runMeasured(bool isValid)
    {
        m_isHopeless = !isValid;
        m_failedRuns = 0;
    }
    void runFailed() { ++m_failedRuns; }
    bool isLinkLost() const { return m_failedRuns >= kMostFailedRuns; }

private:
    unsigned m_count = 1;      ///< attempts of this run
    bool m_isHopeless = false; ///< no attempt of the run before was valid
    unsigned m_failedRuns = 0; ///< in a row
};

} // namespace skyseal::experiment
