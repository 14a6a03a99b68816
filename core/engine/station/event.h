// Rare events of the engine for people: values, in the order in which they happened. Words are made by the reader.
#pragma once

#include "core/channel/events.h"
#include "core/engine/station/snapshot.h"
#include "core/vehicle/vehicle_command.h"

#include <functional>
#include <string>
#include <variant>

namespace skyseal::engine {

struct LinkChanged
{
    LinkSnapshot link;
};
struct VehicleFound
{
    std::uint8_t systemId = 0, type = 0, autopilot = 0;
    bool sealed = false;
};
struct VehicleLost
{
    std::uint8_t systemId = 0;
};
struct VehicleBack
{
    std::uint8_t systemId = 0;
};
struct TextReceived
{
    std::uint8_t systemId = 0;
    vehicle::StatusText text;
};
/// Clear MAVLink claims to be a vehicle whose key is pinned; at most one a second. With `mayBe`, once for each system: a
/// vehicle that is held back, see PendingVehicle.
struct PlaintextRefused
{
    std::uint8_t systemId = 0;
    std::string remoteAddress;
    std::uint64_t frames = 0;
    std::string mayBe = {};
};
/// A sealed peer speaks as a system that it may not speak as; `owner` is the peer to which that belongs, by the list or
/// because it was heard as it before, empty when there is none. At most one a second.
struct SystemRefused
{
    std::uint8_t systemId = 0;
    std::string peer, owner;
    std::uint64_t frames = 0;
};
/// A known agent announces itself and answers no handshake: most likely it does not know this station's key, which stands
/// here for the operator to compare. Told when it begins, and when it is over (answered, or gone).
struct AgentUnanswering
{
    UnansweringAgent agent;
    bool over = false;
};
struct RecordingProblem
{
    std::string file, problem;
};
struct MissionTransferDone
{
    std::uint8_t systemId = 0;
    bool upload = false;
    bool ok = false;
    std::string reason;
};
struct ParameterWritten
{
    std::uint8_t systemId = 0;
    vehicle::Parameter parameter;
    bool ok = false;
    std::string reason;
};

using Event = std::variant<LinkChanged, VehicleFound, VehicleLost, VehicleBack, TextReceived, PlaintextRefused, SystemRefused,
                           AgentUnanswering, RecordingProblem, MissionTransferDone, ParameterWritten, vehicle::CommandResult,
                           channel::SessionUp, channel::SessionDown, channel::PeerMoved, channel::SwitchPending,
                           channel::SwitchDone, channel::HandshakeRefused, channel::ForgeryAlarm>;
/// Publishes one event; called on the I/O thread.
using Notify = std::function<void(Event)>;

} // namespace skyseal::engine
