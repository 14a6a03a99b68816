// Rare events of the station for people and scripts, as values in the order in which they occurred. The reader turns them
// into text.
#pragma once

#include "core/base/compiled_once.h"
#include "core/channel/events.h"
#include "core/engine/common/event_publisher.h"
#include "core/engine/common/link_snapshot.h"
#include "core/engine/common/storage_watch.h"
#include "core/engine/gateway/gateway_event.h"
#include "core/engine/station/other_systems_heard.h"
#include "core/engine/station/unanswering_agent.h"
#include "core/vehicle/event.h"

#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace skyseal::engine {

struct LinkChanged
{
    LinkSnapshot link;
};
/// Also published when another component turned out to be the autopilot of the system.
struct VehicleFound
{
    std::uint8_t systemId = 0, type = 0, autopilot = 0;
    bool sealed = false;
    bool recorded = false; ///< by a recording, whose frames do not say how they were protected
};
struct VehicleLost
{
    std::uint8_t systemId = 0;
};
struct VehicleBack
{
    std::uint8_t systemId = 0;
};
/// Clear MAVLink of a system that must be sealed was refused; at most once a second. With `mayBe`, once for each system: a
/// vehicle awaits approval, see PendingVehicle.
struct PlaintextRefused
{
    std::uint8_t systemId = 0;
    std::string remoteAddress;
    std::uint64_t frames = 0;
    std::string mayBe = {};
};
/// A peer used a system id that it may not use; at most once a second. `owner` is the peer to which the system belongs, by
/// the list or because it used it before; empty if there is none.
struct SystemRefused
{
    std::uint8_t systemId = 0;
    std::string peer, owner;
    std::uint64_t frames = 0;
};
/// A vehicle has the system id of this station, so that neither can be told from the other; at most once a minute. It is not
/// shown.
struct OwnIdClaimed
{
    std::uint8_t systemId = 0, componentId = 0;
    std::string remoteAddress;
};
/// A known agent announces itself and answers no handshake: most likely it does not know this station's key, whose
/// fingerprint is included for the operator to compare. Published at the beginning and at the end (the agent has answered, or
/// is gone).
struct AgentUnanswering
{
    UnansweringAgent agent;
    bool over = false;
};
struct RecordingProblem
{
    std::string file;
    Reason problem;
};
/// The reader did not keep up, and the oldest events before this one were dropped; see OutputQueue.
struct EventsDropped
{
    std::uint64_t events = 0;
};

/// A variant of the alternatives of all `Variants`.
template<typename... Variants> struct Joined;
template<typename... T> struct Joined<std::variant<T...>>
{
    using Type = std::variant<T...>;
};
template<typename... T, typename... U, typename... Rest>
struct Joined<std::variant<T...>, std::variant<U...>, Rest...> : Joined<std::variant<T..., U...>, Rest...>
{};

using StationEvent =
    std::variant<LinkChanged, VehicleFound, VehicleLost, VehicleBack, PlaintextRefused, SystemRefused, OtherSystemsHeard,
                 OwnIdClaimed, AgentUnanswering, RecordingProblem, EventsDropped, CounterStorage>;
using EventVariant = Joined<StationEvent, GatewayEvent, vehicle::Event, channel::Event>::Type;

/// An event of the station itself, of its gateway, of a vehicle or of the channel.
using Event = CompiledOnce<EventVariant>;

/// Whether `T` is an alternative of channel::Event.
template<typename T> inline constexpr bool kIsChannelEvent = std::is_constructible_v<channel::Event, std::in_place_type_t<T>>;

/// The events that a stranger can cause, see EventPublisher.
struct StationCauses : ChannelCauses
{
    using ChannelCauses::operator();
    using ChannelCauses::merge;
    std::optional<StrangerCause> operator()(const PlaintextRefused &refused) const;
    std::optional<StrangerCause> operator()(const AgentUnanswering &unanswering) const;
    static void merge(PlaintextRefused &waiting, const PlaintextRefused &newer);
};

/// Publishes one event; called on the I/O thread.
using Notify = std::function<void(Event)>;

} // namespace skyseal::engine

extern template struct skyseal::CompiledOnce<skyseal::engine::EventVariant>;
