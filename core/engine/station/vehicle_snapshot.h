// The parts of a snapshot that describe the vehicles: those shown, and those in clear that await approval.
#pragma once

#include "core/base/path.h"
#include "core/channel/events.h"
#include "core/channel/session_info.h"
#include "core/vehicle/mission.h"
#include "core/vehicle/parameter.h"
#include "core/vehicle/vehicle_state.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {

/// The ended session over which a vehicle was heard.
struct EndedSession
{
    std::string peerName;
    channel::DownReason reason{};
    double age = 0; ///< seconds since it ended
};

struct VehicleSnapshot
{
    vehicle::VehicleState state;
    LinkId link{};
    std::optional<channel::SessionId> session; ///< over which it was heard last, even if it has ended; nullopt: plain
    std::optional<EndedSession> ended;         ///< set if that session ended and its peer has no other
    double lossPercent = 0;                    ///< by MAVLink sequence numbers, over the last second
    double framesPerSecond = 0;
    std::shared_ptr<const std::vector<vehicle::Parameter>> parameters; ///< null until requested; shared while unchanged
    std::uint32_t parametersExpected = 0;
    vehicle::MissionItems mission, fence, rally; ///< as last read from the vehicle; null before
    /// Why the vehicle may have others by now; empty while there is no sign of it.
    Reason missionOutdated, fenceOutdated, rallyOutdated;
};

/// A vehicle in clear that is not shown, and to which nothing is sent, before the operator allows it; see
/// Station::allowPlaintext().
struct PendingVehicle
{
    std::uint8_t systemId = 0;
    std::string remoteAddress;
    std::string mayBe; ///< names of the known agents, never heard sealed, that it may impersonate
};

} // namespace skyseal::engine
