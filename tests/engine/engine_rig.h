// What the rigs share: engines over real sockets of 127.0.0.1 with hand-driven far ends. Only the CPU time of the engine's own
// thread is measured: the sockets are filled and drained between two readings of the clock.
#pragma once

#include "core/metrics/process_usage.h"
#include "tests/engine/bare_end.h"
#include "tests/engine/sample_traffic.h"

#include <QtCore/QDeadlineTimer>

#include <string>

namespace skyseal::test {

inline constexpr std::size_t kFrames = 512; ///< of one round; the most that one wake-up receives

inline channel::Policy everySuite()
{
    return {channel::defaultSuites(), true, false};
}

std::string loopbackAddress(std::uint16_t port);

/// The sum of the CPU time of several stretches of work.
class CpuTimer
{
public:
    template<typename Work> void time(Work &&work)
    {
        const Duration start = metrics::threadCpuTime();
        work();
        m_sum += metrics::threadCpuTime() - start;
    }
    double nanosecondsEach(std::size_t count) const { return seconds(m_sum) * 1e9 / static_cast<double>(count); }

private:
    Duration m_sum{};
};

/// Ends the program if it waits forever: a fault of the rig, not a slow engine.
class Patience
{
public:
    Patience();
    void check() const;

private:
    QDeadlineTimer m_deadline;
};

/// Runs the event loop and the far end until the session is up under the suite, and settled.
void bringUp(BareEnd &end, crypto::SuiteId suite);

} // namespace skyseal::test
