// Which core each program of a sweep runs on. Programs that wander between cores lose their caches, and two that share a core
// wait for each other; both are measured as cost. Linux only; elsewhere, and with too few cores, the system decides.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace skyseal::experiment {

struct Placement
{
    std::optional<int> station, agent, simulator,
        relay;      ///< numbers of cores; all empty: left to the system; the simulator's alone: there is none
    int usable = 0; ///< cores that this process may use

    /// "station's I/O thread on core 0; agent on core 1; …", or why there is none. Without a comma.
    std::string text() const;
};

/// A core of its own for each program, and for everything else one more, at least. `cores`: those that may be used, of which
/// the first ones are taken; a caller lists one thread of each physical core first.
Placement placementOn(const std::vector<int> &cores);
/// The same on this machine.
Placement placementHere();

/// Lets the calling thread, and the threads and processes that it starts from now on, run on this core only. Has no effect if
/// the system refuses. Safe between fork and exec.
void runOnCore(int core);

/// The same for the lifetime of this object; nullopt: no change.
class OnCore
{
public:
    explicit OnCore(std::optional<int> core);
    ~OnCore();
    OnCore(const OnCore &) = delete;
    OnCore &operator=(const OnCore &) = delete;

private:
    std::vector<int> m_before;
};

} // namespace skyseal::experiment
