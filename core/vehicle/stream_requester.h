// Requests telemetry streams. ArduPilot sends hardly any telemetry until it is requested: its stream groups by
// REQUEST_DATA_STREAM, single messages by SET_MESSAGE_INTERVAL if the firmware supports that. PX4 streams on its own and gets
// no requests. Firmware without SET_MESSAGE_INTERVAL (ArduPilot before 4.0) does not stream its home position, which is
// requested by GET_HOME_POSITION instead. A stream that never arrived is requested again after 2 s, one that stopped after 8 s,
// and less and less often if the vehicle does not have it.
#pragma once

#include "core/vehicle/micro_protocol.h"

#include <array>

namespace skyseal::vehicle {

class StreamRequester : public MicroProtocol
{
public:
    /// Before the first message of a stream: short, since the request or its first answer may have been lost.
    static constexpr Duration kFirstSilence = std::chrono::seconds(2);
    static constexpr Duration kSilence = std::chrono::seconds(8);
    static constexpr Duration kLongestSilence = std::chrono::seconds(64);

    StreamRequester(VehicleContext &context, StreamProfile profile, double rate);

    /// Requests all streams again with the next deadline.
    void setProfile(TimePoint now, StreamProfile profile, double rate);
    /// The vehicle was lost and is back, perhaps restarted: requests all streams again.
    void restart(TimePoint now);

    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    /// The first one starts the requests.
    void handleHeartbeat(TimePoint now) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override;

private:
    static constexpr std::size_t kGroups = 7;
    static constexpr std::size_t kMessages = 8;

    /// A stream group or a single message that should arrive.
    struct Expectation
    {
        TimePoint due = kNever; ///< time of the next request, postponed by each message that arrives
        Duration patience = kFirstSilence;
        bool isRequestPending = false; ///< messages that arrive now still have the old rate
        void request(TimePoint now);
        void requested(TimePoint now);
        void arrived(TimePoint now);
    };

    void noteArrival(TimePoint now, std::uint32_t messageId);
    void handleIntervalResult(TimePoint now, std::uint8_t result);
    bool isActive() const;

    StreamProfile m_profile;
    double m_rate;
    std::optional<VehicleKind> m_kind;
    bool m_intervalsSupported = true; ///< SET_MESSAGE_INTERVAL
    std::array<Expectation, kGroups> m_groups;
    std::array<Expectation, kMessages> m_messages;
    Expectation m_home; ///< HOME_POSITION by request, where it cannot be streamed
};

} // namespace skyseal::vehicle
