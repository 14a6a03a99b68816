// Events of the agent for people and scripts, as values in the order in which they occurred.
#pragma once

#include "core/base/compiled_once.h"
#include "core/channel/events.h"
#include "core/channel/pairing.h"
#include "core/engine/common/event_publisher.h"
#include "core/engine/common/link_snapshot.h"
#include "core/engine/common/storage_watch.h"

#include <cstdint>
#include <string>
#include <variant>

namespace skyseal::engine {

struct AgentLinkChanged
{
    bool groundSide = false;
    LinkSnapshot link;
};
/// Frames of an authenticated peer that were not forwarded to the vehicle; published once per snapshot and peer. The
/// heartbeats of an observer, and late ones, are only counted.
struct FramesRefused
{
    enum class Reason : std::uint8_t {
        Observer, ///< the peer may not command
        System,   ///< the peer may not use the system id
        Late,     ///< the record arrived too late, see channel::Freshness
        TooOften  ///< questions (read-only requests) of an observer beyond QuestionLimit
    };
    Reason reason{};
    std::string peer;
    std::uint32_t messageId = 0; ///< of the newest frame
    std::string messageName;     ///< empty if the dialect does not know the message
    std::uint16_t command = 0;   ///< of a COMMAND_LONG or COMMAND_INT
    std::uint64_t frames = 0;
};
/// An autopilot's heartbeat arrived on the vehicle's side under a system id of a ground station. At most one event a minute for
/// each id.
struct GroundIdClaimed
{
    std::uint8_t systemId = 0;
};
/// Findings of MAVLink signing on the vehicle's side since the last event of this kind; at most one a minute for each kind.
struct VehicleSignatures
{
    enum class Kind : std::uint8_t {
        Verified,       ///< the vehicle signs with the agent's key; also after a period in which it did not
        Unsigned,       ///< frames on the vehicle's side without a signature, not forwarded
        Wrong,          ///< the same with a signature of another key
        Old,            ///< the same with a valid signature, but an old time: replayed, or the vehicle lost its time
        Unsignable,     ///< MAVLink 1 of stations, not forwarded
        KeyChange,      ///< SETUP_SIGNING of stations, not forwarded
        TooManySenders, ///< frames of stations whose senders the vehicle could not remember, not forwarded
        TimeNotStored   ///< `problem` has the reason
    };
    static constexpr std::size_t kKinds = 8;
    Kind kind{};
    std::uint64_t frames = 0;
    std::string problem;
};

using AgentEventVariant = std::variant<AgentLinkChanged, channel::Event, channel::PairingEvent, FramesRefused, GroundIdClaimed,
                                       VehicleSignatures, CounterStorage>;
using AgentEvent = CompiledOnce<AgentEventVariant>;

/// The events that a stranger can cause, see EventPublisher.
struct AgentCauses : ChannelCauses
{
    using ChannelCauses::operator();
    using ChannelCauses::merge;
    std::optional<StrangerCause> operator()(const channel::Event &event) const { return std::visit(ChannelCauses(), event); }
    static void merge(channel::Event &waiting, const channel::Event &newer) { mergeEvents<ChannelCauses>(waiting, newer); }
};

} // namespace skyseal::engine

extern template struct skyseal::CompiledOnce<skyseal::engine::AgentEventVariant>;
