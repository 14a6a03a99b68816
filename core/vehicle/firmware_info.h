// What runs on the autopilot: AUTOPILOT_VERSION, asked for until it comes, by the new command and the old one in turns.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/flight_modes.h"
#include "core/vehicle/message_queue.h"
#include "core/vehicle/vehicle_config.h"

#include <cstdint>
#include <string>

namespace skyseal::vehicle {

class FirmwareInfo
{
public:
    static constexpr Duration kInterval = std::chrono::seconds(2);
    static constexpr int kAttempts = 6;

    explicit FirmwareInfo(const Addressing &addressing) : m_addressing(addressing) {}

    void start(TimePoint now);
    /// `version` as flight_sw_version packs it: major, minor, patch, FIRMWARE_VERSION_TYPE from the highest byte down.
    void handleVersion(std::uint32_t version, VehicleKind kind);
    void handleDeadline(TimePoint now, MessageQueue &outbox);
    TimePoint nextDeadline() const { return m_next; }

    /// "ArduCopter 4.5.7"; empty until known.
    const std::string &text() const { return m_text; }

private:
    Addressing m_addressing;
    TimePoint m_next = kNever;
    int m_attempts = 0;
    std::string m_text;
};

} // namespace skyseal::vehicle
