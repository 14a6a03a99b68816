// MAVLink signing on the vehicle's side (https://mavlink.io/en/guide/message_signing.html): the frames that CommandGate
// admitted go to the vehicle signed with the vehicle's key, whatever signature a station gave them, and only what the vehicle
// signed with that key reaches the ground, byte for byte. Signing authenticates this agent to its autopilot, on a bus that
// other devices share. It is no right: who may command is decided before.
//
// No clock: the time of a signature follows the newest verified one of the vehicle and rises by one with each frame. A vehicle
// that has GPS, or hears a signer with a clock, so sets the time for all. The time is stored ahead (VehicleKey::times).
//
// No I/O but that; I/O thread; allocates nothing for a frame.
#pragma once

#include "core/base/clock.h"
#include "core/base/locked_memory.h"
#include "core/engine/agent/agent_event.h"
#include "core/engine/agent/agent_snapshot.h"
#include "core/engine/agent/vehicle_key.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/signing.h"

#include <array>
#include <vector>

namespace skyseal::engine {

/// Make it with `new`: its pages are locked.
class VehicleSigning : public InLockedMemory
{
public:
    using Time = mavlink::SigningTime;

    /// Of the agent's signatures, whatever the sender of the frame: other signers with the same key, such as a station on the
    /// autopilot's USB port, number their links from 0.
    static constexpr std::uint8_t kLinkId = mavlink::MAV_COMP_ID_ONBOARD_COMPUTER;
    /// How far ahead the time is stored, and when again. After a restart, the vehicle may be behind by the first: less than
    /// the minute that a new stream may be.
    static constexpr Time kAhead = 5'000'000, kLeastAhead = 1'000'000;
    /// An autopilot keeps the times of at most 16 senders until it restarts, and refuses others. Some of these places stay free
    /// for signers elsewhere, and those who may only ask cannot take the places of those who command.
    static constexpr std::size_t kMostSenders = 14, kMostAskers = 4;
    static constexpr Duration kCatchUpEvery = std::chrono::seconds(1);
    static constexpr Duration kReportEvery = std::chrono::minutes(1);

    /// `acceptUnsigned`: frames of the vehicle's side that are not signed reach the ground as well; never wrongly signed ones.
    VehicleSigning(VehicleKey key, bool acceptUnsigned);

    /// Whether a whole frame of the vehicle's link is the vehicle's. Counts it.
    bool accept(ByteView frame);
    /// For a frame that was refused: a signed TIMESYNC request for its sender, if the key was right and only the time old. A
    /// vehicle that lost its time takes that of the request, and is accepted from then on. Empty otherwise, and in the second
    /// after the last one. Valid until the next call to this object.
    ByteView catchUp(TimePoint now, ByteView refused);
    /// A signed copy of a whole frame that CommandGate admitted, valid until the next call to this object. Empty, and counted,
    /// if the frame cannot be signed, or would change the key. `mayCommand`: its station may.
    ByteView sign(ByteView frame, bool mayCommand);

    const SigningCounters &counters() const { return m_counters; }
    /// What is to be reported now, at most once a minute for each kind. Call about once a second.
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

    mavlink::FrameSigner m_signer;
    mavlink::SignatureVerifier m_verifier;
    std::unique_ptr<keys::SigningTimeFile> m_times;
    const bool m_acceptUnsigned;
    Time m_stored;                                                            ///< or on its way there
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
