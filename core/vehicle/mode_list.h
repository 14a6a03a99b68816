// The modes that the vehicle names itself, by the standard modes protocol
// (https://mavlink.io/en/services/standard_modes.html): requests AVAILABLE_MODES once the firmware is known, the missing ones
// again, and all when AVAILABLE_MODES_MONITOR says that they have changed, as when a program beside PX4 adds one. A vehicle
// without the protocol is not asked any more, and one on a slow link is not asked at all.
#pragma once

#include "core/vehicle/micro_protocol.h"

#include <map>

namespace skyseal::vehicle {

class ModeList : public MicroProtocol
{
public:
    static constexpr Duration kSilence = std::chrono::seconds(2); ///< after which what is missing is requested again
    static constexpr int kAttempts = 3;                           ///< without an answer

    ModeList(VehicleContext &context, StreamProfile profile) : MicroProtocol(context), m_profile(profile) {}

    void setProfile(StreamProfile profile) { m_profile = profile; }

    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleHeartbeat(TimePoint now) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override { return m_next; }

private:
    void start(TimePoint now);
    void handleMode(TimePoint now, const mavlink::AvailableModes &mode);
    void handleResult(const mavlink::CommandAck &ack);
    void publish();

    StreamProfile m_profile;
    std::map<std::uint8_t, mavlink::AvailableModes> m_modes; ///< those that came, by their index
    std::uint8_t m_expected = 0;                             ///< 0: not known
    std::optional<VehicleKind> m_kind;                       ///< that was asked
    std::optional<std::uint8_t> m_sequence;                  ///< of AVAILABLE_MODES_MONITOR
    int m_attempts = 0;
    TimePoint m_next = kNever;
};

} // namespace skyseal::vehicle
