// Asks a vehicle for telemetry. ArduPilot sends next to nothing until it is asked: its stream groups are asked for by
// REQUEST_DATA_STREAM, single messages by SET_MESSAGE_INTERVAL where that is understood. PX4 streams by itself and is not
// asked. What was never heard is asked for again after 2 s, what fell silent after 8 s, ever more rarely when the vehicle
// does not have it.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/flight_modes.h"
#include "core/vehicle/message_queue.h"
#include "core/vehicle/vehicle_config.h"

#include <array>

namespace skyseal::vehicle {

class StreamRequester
{
public:
    /// Of what was never heard: asked for again soon, since the question or its first answer may have been lost.
    static constexpr Duration kFirstSilence = std::chrono::seconds(2);
    static constexpr Duration kSilence = std::chrono::seconds(8);
    static constexpr Duration kLongestSilence = std::chrono::seconds(64);

    StreamRequester(const Addressing &addressing, StreamProfile profile, double rate);

    /// Everything is asked for anew with the next deadline.
    void setProfile(TimePoint now, StreamProfile profile, double rate);
    /// The first one starts the asking.
    void handleHeartbeat(TimePoint now, VehicleKind kind);
    void handleMessage(TimePoint now, std::uint32_t messageId);
    /// The vehicle was lost and is there again, perhaps restarted.
    void handleReturn(TimePoint now);
    /// The answer to SET_MESSAGE_INTERVAL.
    void handleIntervalResult(std::uint8_t result);
    void handleDeadline(TimePoint now, MessageQueue &outbox);
    TimePoint nextDeadline() const;

private:
    static constexpr std::size_t kGroups = 7;
    static constexpr std::size_t kMessages = 8;

    /// A stream group or a single message that is expected to come.
    struct Expectation
    {
        TimePoint due = kNever; ///< to be asked for then, unless it comes before
        Duration patience = kFirstSilence;
        bool unasked = false; ///< it may come at another rate than the one that was not asked for yet
        void ask(TimePoint now);
        void asked(TimePoint now);
        void came(TimePoint now);
    };

    void restart(TimePoint now);
    bool isActive() const;

    Addressing m_addressing;
    StreamProfile m_profile;
    double m_rate;
    std::optional<VehicleKind> m_kind;
    bool m_intervalsUnderstood = true;
    std::array<Expectation, kGroups> m_groups;
    std::array<Expectation, kMessages> m_messages;
};

} // namespace skyseal::vehicle
