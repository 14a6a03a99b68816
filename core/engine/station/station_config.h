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
    std::optional<crypto::SuiteId> preferredSuite; ///< sessions begin with it where both ends permit it
    bool record = true;
    std::string recordFolder;
    bool lowBandwidth = false; ///< ask vehicles for slower streams
    double streamRate = 0;     ///< Hz for every stream of every vehicle, instead of a profile; 0 = the profile's
    Duration timeSyncEvery = std::chrono::seconds(1); ///< how often latency is measured
    int snapshotsPerSecond = 30;                      ///< at most 30; 0: none but at the end
    bool diagnostics = true;  ///< off: snapshots have no time lines, and neither CPU load nor memory of the process
    bool ownHeartbeat = true; ///< off: vehicles hear no heartbeat of this station, which has no pilot
};

} // namespace skyseal::engine
