// MAVLink signing as ArduPilot does it (GCS_Signing.cpp, and the signature check of the MAVLink C library): SETUP_SIGNING gives
// the key, a key and time of zeros end it. From then on every frame is signed, and others are ignored, except reports of radios
// and what comes over a trusted link, such as USB. One time serves for sending and receiving; it follows accepted frames and
// the GPS, is saved every 30 s, and goes on a minute after the saved one when the vehicle starts again.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/signing.h"
#include "core/sim/link_trust.h"

#include <optional>

namespace skyseal::sim {

class MessageSigning
{
public:
    static constexpr Duration kSaveEvery = std::chrono::seconds(30);
    static constexpr mavlink::SigningTime kAfterSaved = mavlink::kSigningMinute;
    static constexpr std::size_t kMostStreams = 16;

    /// Whether to act on the frame.
    bool accepts(const mavlink::Frame &frame, LinkTrust trust);
    void setUp(TimePoint now, const mavlink::SetupSigning &setup);
    /// The time of the GPS.
    void noteTime(WallTime time);
    void saveIfDue(TimePoint now);
    /// The vehicle starts again: what was not saved is lost.
    void restart();
    /// For the writer of outgoing frames; null while signing is off. Ask again after setUp() and restart().
    mavlink::FrameSigner *signer() { return m_live ? &m_live->signer : nullptr; }

private:
    struct Live
    {
        mavlink::FrameSigner signer;
        mavlink::SignatureVerifier verifier;
    };

    Key32 m_key;
    mavlink::SigningTime m_saved = 0;
    TimePoint m_saveDue{};
    std::optional<Live> m_live;
};

} // namespace skyseal::sim
