// The configuration of a station, as one plain value.
#pragma once

#include "core/base/clock.h"
#include "core/channel/policy.h"
#include "core/engine/common/key_paths.h"
#include "core/engine/common/secure_mode.h"
#include "core/mavlink/enums.h"

#include <cstdint>
#include <optional>
#include <string>

namespace skyseal::engine {

struct StationConfig
{
    std::uint8_t systemId = 255;
    std::uint8_t componentId = mavlink::MAV_COMP_ID_MISSIONPLANNER; ///< the customary one of ground stations
    SecureMode secure = SecureMode::Preferred;
    KeyPaths keys;
    channel::Policy policy;
    std::optional<crypto::SuiteId> preferredSuite; ///< sessions begin with it if both ends permit it
    bool record = true;
    std::string recordFolder;
    bool lowBandwidth = false; ///< request slower streams of vehicles
    double streamRate = 0;     ///< Hz for all streams of all vehicles, in place of a profile; 0 = the rates of the profile
    Duration timeSyncEvery = std::chrono::seconds(1); ///< interval of latency measurements
    int snapshotsPerSecond = 30;                      ///< at most 30; 0: only the last one
    bool diagnostics = true;  ///< off: snapshots have no time lines, and neither CPU load nor memory of the process
    bool ownHeartbeat = true; ///< off: this station, which has no pilot, sends no heartbeat
};

} // namespace skyseal::engine
