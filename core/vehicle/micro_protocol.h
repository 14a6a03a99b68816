// Base of the clients that each speak one MAVLink micro-protocol (commands, parameters, missions, …) with one vehicle. Vehicle
// owns them, passes every frame, request and deadline to them, and drains the messages and events that they leave in the
// shared VehicleContext. Sans-I/O: time enters as an argument.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/event.h"
#include "core/vehicle/flight_modes.h"
#include "core/vehicle/message_io.h"
#include "core/vehicle/request.h"
#include "core/vehicle/rtt_estimator.h"
#include "core/vehicle/vehicle_config.h"
#include "core/vehicle/vehicle_state.h"

#include <cmath>
#include <deque>
#include <optional>
#include <vector>

namespace skyseal::vehicle {

class MicroProtocol;

/// State and output of one vehicle, shared by its clients.
struct VehicleContext
{
    Addressing addressing;
    VehicleState state{};
    MessageQueue outbox{64};
    std::deque<Event> events{};
    std::vector<MicroProtocol *> clients{}; ///< in the order of their construction

    /// Queues a message; its target fields, if it has any, become the vehicle's autopilot.
    template<typename Message> void send(const Message &message, bool urgent = true)
    {
        sendTo(addressing.component, message, urgent);
    }
    /// Queues a message to a component of the vehicle; 0: to all of them. One that the vehicle's version of MAVLink cannot
    /// carry is dropped; Vehicle::perform() has refused requests that need one.
    template<typename Message> void sendTo(std::uint8_t component, Message message, bool urgent = true)
    {
        if constexpr (requires { message.mission_type; }) {
            if (state.mavlinkVersion == 1 && message.mission_type != mavlink::MAV_MISSION_TYPE_MISSION)
                return;
        }
        if constexpr (requires { message.target_system; })
            message.target_system = addressing.system;
        if constexpr (requires { message.target_component; })
            message.target_component = component;
        outbox.push(pack(message, urgent));
    }
    /// The same to the autopilot, whatever version the vehicle speaks.
    template<typename Message> void sendInVersion2(Message message)
    {
        message.target_system = addressing.system;
        message.target_component = addressing.component;
        OutMessage packed = pack(message);
        packed.version = 2;
        outbox.push(packed);
    }
    VehicleKind kind() const { return {state.type, state.autopilot}; }
};

class MicroProtocol
{
public:
    /// Registers the client in `context`, which must be destroyed together with it.
    explicit MicroProtocol(VehicleContext &context) : m_context(context) { context.clients.push_back(this); }
    virtual ~MicroProtocol() = default;
    MicroProtocol(const MicroProtocol &) = delete;
    MicroProtocol &operator=(const MicroProtocol &) = delete;

    /// Starts a request of this protocol. Returns false, and does nothing, for requests of others.
    virtual bool perform(TimePoint, RequestId, const Request &) { return false; }
    /// Handles a frame of the autopilot. Returns true if neither another client nor the telemetry needs it.
    virtual bool handleFrame(TimePoint, const mavlink::Frame &) { return false; }
    /// Called after a heartbeat of the autopilot has been taken into the state.
    virtual void handleHeartbeat(TimePoint) {}
    /// A complete status text of any component.
    virtual void handleText(const StatusText &) {}
    virtual void handleDeadline(TimePoint now) = 0;
    /// kNever while nothing is pending.
    virtual TimePoint nextDeadline() const = 0;
    /// Of the transfer in progress; nullopt without one.
    virtual std::optional<TransferProgress> progress() const { return std::nullopt; }

protected:
    const Addressing &addressing() const { return m_context.addressing; }
    VehicleState &state() { return m_context.state; }
    const VehicleState &state() const { return m_context.state; }
    VehicleKind kind() const { return m_context.kind(); }
    /// Whether messages may be sent that nobody has asked for. Not over a satellite modem, where each has its price.
    bool mayAsk() const { return !state().highLatency; }
    template<typename Message> void send(const Message &message, bool urgent = true) { m_context.send(message, urgent); }
    void report(Event event) { m_context.events.push_back(std::move(event)); }
    /// Lets an estimator that has measured nothing begin with the round trip that TIMESYNC measures.
    void suppose(RttEstimator &rtt) const
    {
        if (!std::isnan(state().latency))
            rtt.suppose(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(state().latency)));
    }
    /// True if the request cancels the transfer that `current` started.
    static bool isCancelOf(const Request &request, RequestId current)
    {
        const auto *cancel = std::get_if<CancelTransfer>(&request);
        return cancel && cancel->transfer == current;
    }

    VehicleContext &m_context;
};

} // namespace skyseal::vehicle
