// Which component of a system is its autopilot. Components of a system share one system id; companion computers, gimbals,
// cameras and radios send heartbeats of their own, often before the autopilot has started.
// https://mavlink.io/en/services/heartbeat.html
#pragma once

#include "core/mavlink/frame.h"
#include "core/mavlink/messages.h"

#include <optional>

namespace skyseal::mavlink {

/// How much speaks for a component being the autopilot of its system. A component with a greater claim takes over at any time.
enum class AutopilotClaim : std::uint8_t {
    None,     ///< a ground station, gimbal, camera, companion computer or another part
    Generic,  ///< it names a kind of vehicle, and no known autopilot
    Named,    ///< it names its autopilot
    Component ///< component 1, the autopilot's (MAV_COMP_ID_AUTOPILOT1)
};

/// What a HEARTBEAT says, or HIGH_LATENCY2 or HIGH_LATENCY, which an autopilot sends in its place over a satellite modem;
/// nullopt for other messages. `before` is what the last one said, which counts for what the message does not say.
/// https://mavlink.io/en/services/high_latency.html
std::optional<Heartbeat> heartbeatOf(const Frame &frame, const Heartbeat &before = {});
/// True for the two messages that stand for HEARTBEAT.
bool isHighLatency(std::uint32_t messageId);

/// The claim of the component that sent this heartbeat, by autopilot and type of the message.
AutopilotClaim autopilotClaim(std::uint8_t componentId, const Heartbeat &heartbeat);

} // namespace skyseal::mavlink
