// A Vehicle on a simulated clock with a hand-driven peer: messages are packed into real frames and read back as such, so
// that nothing in between is assumed.
#pragma once

#include "core/mavlink/frame_writer.h"
#include "core/vehicle/message_io.h"
#include "core/vehicle/vehicle.h"

#include <QtTest/QTest>

#include <deque>
#include <optional>
#include <vector>

namespace skyseal::vehicle {

inline TimePoint at(double s)
{
    return TimePoint{} + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

/// One component that sends; a frame is valid until the next one is made.
class Sender
{
public:
    explicit Sender(std::uint8_t system = 1, std::uint8_t component = 1, int version = 2) : m_writer(system, component, version)
    {}

    template<typename Message> mavlink::Frame frame(const Message &message)
    {
        return *mavlink::readFrame(m_writer.write(message, m_buffer), mavlink::Dialect::builtin());
    }

private:
    mavlink::FrameWriter m_writer;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> m_buffer{};
};

/// The typed message in an OutMessage.
template<typename Message> std::optional<Message> as(const OutMessage &out)
{
    if (out.id != Message::kId)
        return std::nullopt;
    return Message::decode(out.view());
}

inline mavlink::Heartbeat heartbeat(std::uint32_t mode = 0, bool armed = false, std::uint8_t type = mavlink::MAV_TYPE_QUADROTOR,
                                    std::uint8_t autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA)
{
    mavlink::Heartbeat out;
    out.type = type;
    out.autopilot = autopilot;
    out.base_mode = static_cast<std::uint8_t>(0x51 | (armed ? 0x80 : 0));
    out.custom_mode = mode;
    out.system_status = mavlink::MAV_STATE_STANDBY;
    return out;
}

inline mavlink::Statustext statusText(std::string_view text, std::uint8_t severity = 2, std::uint16_t id = 0,
                                      std::uint8_t chunk = 0)
{
    mavlink::Statustext out;
    out.severity = severity;
    out.id = id;
    out.chunk_seq = chunk;
    mavlink::setText(out.text, text);
    return out;
}

class Harness
{
public:
    explicit Harness(VehicleConfig config = {}) : vehicle(config, 1, 1) {}

    /// An ArduCopter in this mode that has said so; what the vehicle asked for at once is thrown away.
    static Harness copter(std::uint32_t mode = 0, bool armed = false) { return quiet(heartbeat(mode, armed)); }
    static Harness px4() { return quiet(heartbeat(0, false, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_PX4)); }

    template<typename Message> void feed(const Message &message) { vehicle.handleFrame(now, {}, sender.frame(message)); }

    void ack(std::uint16_t command, std::uint8_t result, std::uint8_t targetSystem = 255)
    {
        mavlink::CommandAck message;
        message.command = command;
        message.result = result;
        message.target_system = targetSystem;
        message.target_component = targetSystem ? 190 : 0;
        feed(message);
    }

    /// All that goes out now.
    std::vector<OutMessage> sent()
    {
        std::vector<OutMessage> out;
        while (const OutMessage *message = vehicle.pollOutgoing())
            out.push_back(*message);
        return out;
    }

    /// Only the messages of one kind; the others are thrown away.
    template<typename Message> std::vector<Message> sentOf()
    {
        std::vector<Message> out;
        for (const OutMessage &message : sent()) {
            if (const auto typed = as<Message>(message))
                out.push_back(*typed);
        }
        return out;
    }

    /// Lets the clock run, every deadline handled at its exact time.
    void runUntil(TimePoint end)
    {
        while (vehicle.nextDeadline() <= end) {
            now = std::max(now, vehicle.nextDeadline());
            vehicle.handleDeadline(now);
        }
        now = end;
    }

    /// The time of the next message of this kind, its deadline handled; the others are thrown away.
    template<typename Message> std::optional<std::pair<TimePoint, Message>> nextSent(TimePoint end)
    {
        for (;;) {
            while (const OutMessage *message = vehicle.pollOutgoing()) {
                if (const auto typed = as<Message>(*message))
                    return std::pair(now, *typed);
            }
            const TimePoint next = vehicle.nextDeadline();
            if (next > end)
                return std::nullopt;
            now = std::max(now, next);
            vehicle.handleDeadline(now);
        }
    }

    /// The oldest event of this type; events of other types are kept for later calls.
    template<typename T> std::optional<T> poll()
    {
        while (auto event = vehicle.pollEvent())
            m_events.push_back(std::move(*event));
        for (auto event = m_events.begin(); event != m_events.end(); ++event) {
            if (T *found = std::get_if<T>(&*event)) {
                T out = std::move(*found);
                m_events.erase(event);
                return out;
            }
        }
        return std::nullopt;
    }

    TimePoint now = at(100);
    Vehicle vehicle;
    Sender sender;

private:
    static Harness quiet(const mavlink::Heartbeat &heartbeat)
    {
        VehicleConfig config;
        config.streams = StreamProfile::Quiet;
        Harness out(config);
        out.feed(heartbeat);
        // So that nothing asks for it in between; without MAVLink FTP, so that parameters come one by one.
        out.feed(mavlink::AutopilotVersion{.capabilities = mavlink::MAV_PROTOCOL_CAPABILITY_MAVLINK2
                                               | mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_FENCE
                                               | mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_RALLY});
        out.sent();
        return out;
    }

    std::deque<Event> m_events;
};

} // namespace skyseal::vehicle
