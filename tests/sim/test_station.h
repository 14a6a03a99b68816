// A ground station in a test: speaks typed messages to one simulated vehicle on a simulated clock, over a link that may lose
// frames, and remembers what came back.
#pragma once

#include "core/mavlink/enums.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/sim/simulated_vehicle.h"
#include "tests/support/command_long.h"

#include <functional>

namespace skyseal::sim {

class TestStation
{
public:
    explicit TestStation(const SimulatedVehicleConfig &config = {}, double loss = 0, std::uint64_t seed = 1)
        : vehicle(config, TimePoint{}), m_loss(loss), m_dice(seed, 99)
    {}

    /// Lives on; heartbeats go out once a second unless `silent`.
    void run(double forSeconds)
    {
        const TimePoint end = now + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(forSeconds));
        while (now < end) {
            now += step;
            if (!silent && now >= m_nextHeartbeat) {
                m_nextHeartbeat = now + std::chrono::seconds(1);
                mavlink::Heartbeat heartbeat;
                heartbeat.type = mavlink::MAV_TYPE_GCS;
                heartbeat.autopilot = mavlink::MAV_AUTOPILOT_INVALID;
                send(heartbeat);
            }
            vehicle.advance(now);
            collect();
        }
    }

    /// Runs until `condition` holds; false when it took longer than `limit` seconds.
    bool until(const std::function<bool()> &condition, double limit)
    {
        const TimePoint end = now + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(limit));
        while (!condition()) {
            if (now >= end)
                return false;
            run(seconds(step));
        }
        return true;
    }

    template<typename Message> void send(const Message &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const auto bytes = writer.write(message, buffer);
        if (m_dice.uniform() < m_loss)
            return;
        deliver(bytes);
    }

    void deliver(ByteView bytes)
    {
        if (const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin()))
            vehicle.handleFrame(now, *frame);
        collect();
    }

    /// Sends a COMMAND_LONG and gives its result; -1 when there was no answer.
    int command(std::uint16_t id, std::array<float, 7> p = {}, std::uint8_t target = 1)
    {
        return resultOf(test::commandLong(id, p, target));
    }
    /// The same for any COMMAND_LONG or COMMAND_INT.
    template<typename Command> int resultOf(const Command &command)
    {
        const std::size_t before = all<mavlink::CommandAck>().size();
        send(command);
        const auto acks = all<mavlink::CommandAck>();
        if (acks.size() != before + 1 || acks.back().command != command.command || acks.back().target_system != 255
            || acks.back().target_component != 190)
            return -1;
        return acks.back().result;
    }

    /// A COMMAND_INT to the vehicle, for a place in degrees × 10^7 and m.
    static mavlink::CommandInt commandAt(std::uint16_t id, std::uint8_t frame, std::int32_t x, std::int32_t y, float z = 0)
    {
        mavlink::CommandInt out;
        out.target_system = 1;
        out.command = id;
        out.frame = frame;
        out.x = x;
        out.y = y;
        out.z = z;
        return out;
    }

    /// Boots, and climbs in GUIDED to a height in m; false when anything of that was refused.
    bool takeOff(float height)
    {
        using namespace mavlink;
        run(6);
        return command(MAV_CMD_DO_SET_MODE, {1, 4}) == MAV_RESULT_ACCEPTED
            && command(MAV_CMD_COMPONENT_ARM_DISARM, {1}) == MAV_RESULT_ACCEPTED
            && command(MAV_CMD_NAV_TAKEOFF, {0, 0, 0, 0, 0, 0, height}) == MAV_RESULT_ACCEPTED
            && until([&] { return vehicle.autopilot().heightAboveHome() > static_cast<double>(height) - 0.3; }, 40);
    }

    /// Hovers in LOITER at a height in m, and flies where the sticks point: GUIDED would refuse to leave a fence.
    bool loiter(float height)
    {
        return takeOff(height) && command(mavlink::MAV_CMD_DO_SET_MODE, {1, 5}) == mavlink::MAV_RESULT_ACCEPTED;
    }

    void setParameter(std::string_view name, float value)
    {
        mavlink::ParamSet set;
        set.target_system = 1;
        std::copy(name.begin(), name.end(), set.param_id.begin());
        set.param_value = value;
        send(set);
    }

    FlightMode mode() const { return vehicle.autopilot().modes().current(); }

    template<typename Message> std::vector<Message> all() const
    {
        std::vector<Message> out;
        for (const Bytes &bytes : received) {
            const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
            if (frame && frame->messageId() == Message::kId)
                out.push_back(Message::decode(frame->payload()));
        }
        return out;
    }
    template<typename Message> std::size_t count() const { return all<Message>().size(); }
    template<typename Message> Message last() const
    {
        for (auto bytes = received.rbegin(); bytes != received.rend(); ++bytes) {
            const auto frame = mavlink::readFrame(*bytes, mavlink::Dialect::builtin());
            if (frame && frame->messageId() == Message::kId)
                return Message::decode(frame->payload());
        }
        return {};
    }

    bool said(std::string_view words) const
    {
        for (const auto &text : all<mavlink::Statustext>()) {
            if (std::string_view(text.text.data(), text.text.size()).find(words) != std::string_view::npos)
                return true;
        }
        return false;
    }

    /// Forgets what came so far: whole flights are long.
    void forget() { received.clear(); }

    SimulatedVehicle vehicle;
    mavlink::FrameWriter writer{255, 190};
    TimePoint now{};
    Duration step = std::chrono::milliseconds(20);
    bool silent = false;
    std::vector<Bytes> received;
    std::function<void(const mavlink::Frame &)> onFrame; ///< answers at once, as a station does

private:
    void collect()
    {
        for (ByteView bytes = vehicle.pollFrame(); !bytes.empty(); bytes = vehicle.pollFrame()) {
            if (m_dice.uniform() < m_loss)
                continue;
            received.emplace_back(bytes.begin(), bytes.end());
            if (onFrame) {
                const Bytes copy = received.back();
                if (const auto frame = mavlink::readFrame(copy, mavlink::Dialect::builtin()))
                    onFrame(*frame);
            }
        }
    }

    double m_loss;
    Noise m_dice;
    TimePoint m_nextHeartbeat{};
};

} // namespace skyseal::sim
