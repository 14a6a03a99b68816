// A whole station whose agent is driven by hand.
#pragma once

#include "tests/engine/engine_rig.h"

#include <memory>
#include <vector>

namespace skyseal::engine {
class StationCore;
struct Snapshot;
} // namespace skyseal::engine

namespace skyseal::test {

/// A whole station: the same and vehicles, counters, snapshots; nothing is recorded.
class StationRig
{
public:
    /// `bound`: the systems that the agent's key is bound to; empty = any.
    explicit StationRig(crypto::SuiteId suite, std::vector<std::uint8_t> bound = {});
    ~StationRig();
    double receive();
    /// Frames accepted so far.
    std::uint64_t frames();
    /// Frames refused because their sender may not use system 1.
    std::uint64_t refused();

private:
    void awaitSnapshot();

    Introduced m_keys;
    std::unique_ptr<engine::StationCore> m_station;
    std::shared_ptr<const engine::Snapshot> m_snapshot;
    std::unique_ptr<BareEnd> m_air;
    SampleTraffic m_telemetry{kFrames};
};

} // namespace skyseal::test
