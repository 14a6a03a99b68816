// MAVLink signing on the vehicle's side (https://mavlink.io/en/guide/message_signing.html): the frames that CommandGate
// admitted are sent to the vehicle signed with the vehicle's key, replacing any signature of the station, and only frames that
// the vehicle signed with that key are forwarded to the ground, byte for byte. Signing authenticates this agent to its
// autopilot on a bus with other devices. It grants no rights: CommandGate has decided before which stations may command.
//
// No clock: the time of a signature follows the newest verified one of the vehicle and increases by one with each frame. A
// vehicle with GPS, or one that receives a signer with a clock, thus sets the time for all. The time is stored ahead
// (VehicleKey::times).
//
// No other I/O; I/O thread; allocates nothing for a frame.
#pragma once

#include "core/base/clock.h"
#include "core/engine/agent/agent_event.h"
#include "core/engine/agent/agent_snapshot.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/signature.h"

#include <array>
#include <memory>
#include <vector>

namespace skyseal::keys {
class SigningTimeFile;
}

namespace skyseal::engine {

struct VehicleKey;

class VehicleSigning
{
public:
    using Time = mavlink::SigningTime;

    /// Link id of the agent's signatures for all senders: other signers with the same key, such as a station on the autopilot's
    /// USB port, number their links from 0.
    static constexpr std::uint8_t kLinkId = mavlink::MAV_COMP_ID_ONBOARD_COMPUTER;
    /// The time is stored kAhead ahead, and again when less than kLeastAhead is left. After a restart, the vehicle may be
    /// behind by kAhead, which is less than the permitted minute of a new stream.
    static constexpr Time kAhead = 5'000'000, kLeastAhead = 1'000'000;
    /// An autopilot keeps the times of at most 16 senders until it restarts, and refuses others. Some of these places stay free
    /// for other signers, and observers cannot take the places of pilots.
    static constexpr std::size_t kMostSenders = 14, kMostAskers = 4;
    static constexpr Duration kCatchUpEvery = std::chrono::seconds(1);
    static constexpr Duration kReportEvery = std::chrono::minutes(1);

    /// `acceptUnsigned`: unsigned frames of the vehicle's side are forwarded to the ground as well; never wrongly signed ones.
    VehicleSigning(VehicleKey key, bool acceptUnsigned);
    ~VehicleSigning();

    /// Whether a whole frame from the vehicle's link is accepted as the vehicle's. Counts it.
    bool accept(ByteView frame);
    /// For a refused frame: a signed TIMESYNC request to its sender, if the key was correct and only the time old. A vehicle
    /// that lost its time adopts that of the request, and is accepted from then on. Empty otherwise, and within a second of the
    /// last request. Valid until the next call to this object.
    ByteView catchUp(TimePoint now, ByteView refused);
    /// A signed copy of a whole frame that CommandGate admitted, valid until the next call to this object. Empty, and counted,
    /// if the frame cannot be signed, or would change the key. `mayCommand`: whether its station may command.
    ByteView sign(ByteView frame, bool mayCommand);

    const SigningCounters &counters() const { return m_counters; }
    /// The reports that are due, at most one a minute for each kind. Call about once a second.
    std::vector<VehicleSignatures> takeReports(TimePoint now);

private:
    using Kind = VehicleSignatures::Kind;
    struct Sender
    {
        std::uint8_t system = 0, component = 0;
        bool mayCommand = false;
    };
    struct Pending
    {
        std::uint64_t frames = 0;
        TimePoint due = TimePoint::min();
    };

    bool refuse(std::uint64_t &counter, Kind kind);
    bool hasPlace(ByteView frame, bool mayCommand);
    ByteView signedCopy(ByteView frame);
    void storeTime();
    Pending &pending(Kind kind) { return m_pending[static_cast<std::size_t>(kind)]; }

    struct Keyed; ///< holds the key, in locked pages
    std::unique_ptr<Keyed> m_keyed;
    std::unique_ptr<keys::SigningTimeFile> m_times;
    const bool m_acceptUnsigned;
    Time m_stored;                                                            ///< stored, or being stored
    mavlink::SignatureVerdict m_refusedFor = mavlink::SignatureVerdict::Good; ///< the newest frame
    TimePoint m_catchUpDue = TimePoint::min();
    std::array<Sender, kMostSenders> m_senders;
    std::size_t m_senderCount = 0, m_askerCount = 0;
    SigningCounters m_counters;
    std::array<Pending, VehicleSignatures::kKinds> m_pending;
    std::uint64_t m_verifiedAtReport = 0, m_refusedAtReport = 0;
    bool m_verifiedReported = false;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> m_buffer;
};

} // namespace skyseal::engine
