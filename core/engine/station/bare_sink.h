// Receives the frames of a link in plain MAVLink whose vehicle encrypts the payloads as MAVSec's published code does, for a
// measurement of that code: decrypts them and passes everything on. INSECURE (core/crypto/mavsec_cipher.h). Unlike a link of
// MavsecSink, such a link is sent to, in clear. I/O thread.
#pragma once

#include "core/crypto/mavsec_cipher.h"
#include "core/engine/common/ingress.h"
#include "core/engine/common/mavsec_stream.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

#include <bitset>

namespace skyseal::engine {

class BareSink final : public IngressSink
{
public:
    /// `rest`, which must outlive this object, receives everything. `unreadable` counts the frames that are not passed on.
    BareSink(MavsecStream stream, IngressSink &rest, std::uint64_t &unreadable)
        : m_stream(std::move(stream)), m_rest(rest), m_unreadable(unreadable)
    {}

    bool takePairing(const link::Link &link, const link::ReceivedBlock &message) override
    {
        return m_rest.takePairing(link, message);
    }
    bool namesSession(ByteView message) const override { return m_rest.namesSession(message); }
    bool takeRecord(const link::Link &link, const link::ReceivedBlock &message) override
    {
        return m_rest.takeRecord(link, message);
    }
    void takeSealedInPlace(const link::Link &link, const link::ReceivedBlock &frame) override
    {
        m_rest.takeSealedInPlace(link, frame);
    }
    void takeClear(const link::Link &link, const link::ReceivedBlock &block, const mavlink::ScanItem &item) override
    {
        if (!item.frame)
            return m_rest.takeClear(link, block, item);
        mavlink::ScanItem clear = item;
        clear.frame = m_stream.open(*item.frame);
        clear.bytes = clear.frame->bytes();
        if (isReadable(*clear.frame))
            m_rest.takeClear(link, block, clear);
        else
            ++m_unreadable;
    }
    void takeUnusable(const link::Link &link, Unusable what) override { m_rest.takeUnusable(link, what); }

private:
    /// Nothing authenticates a frame, but a heartbeat says little enough to show whether it was decrypted rightly. Frames of a
    /// system count by its newest one: frames in another key, or in clear, must not look like telemetry.
    bool isReadable(const mavlink::Frame &frame)
    {
        const std::uint8_t system = frame.systemId();
        if (frame.messageId() == mavlink::Heartbeat::kId) {
            constexpr std::uint8_t kVersion = 3, kLastType = 60, kLastAutopilot = 30; // of MAVLink's common messages, with room
            const auto said = mavlink::Heartbeat::decode(frame.payload());
            m_readable[system] = said.mavlink_version == kVersion && said.type <= kLastType && said.autopilot <= kLastAutopilot
                && said.system_status <= mavlink::MAV_STATE_FLIGHT_TERMINATION;
        }
        return m_readable[system];
    }

    MavsecStream m_stream;
    IngressSink &m_rest;
    std::uint64_t &m_unreadable;
    std::bitset<256> m_readable; ///< by system id
};

} // namespace skyseal::engine
