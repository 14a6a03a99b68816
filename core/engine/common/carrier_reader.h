// Extracts messages of the channel from carriers other than datagrams: COBS frames of a byte stream and the payloads of
// TUNNEL (core/channel/PROTOCOL.md). Also tracks which streams carry COBS, so that their bytes are not searched for MAVLink.
// On a stream of MAVLink, bytes between two zeros resemble a message of the channel now and then (records in TUNNEL are random
// bytes), and anybody whose frames a router passes on can make them do so. Only a record that was opened therefore ends the
// search for MAVLink. I/O thread; no I/O itself.
#pragma once

#include "core/channel/cobs.h"
#include "core/channel/tunnel_parts.h"
#include "core/link/link.h"
#include "core/mavlink/frame_scanner.h"

#include <map>
#include <memory>
#include <optional>
#include <set>

namespace skyseal::engine {

class CarrierReader
{
public:
    /// Without a message in COBS for this long, another program may be sending on the stream.
    static constexpr Duration kBelievedFor = std::chrono::seconds(10);
    /// Greatest number of remembered nodes behind routers.
    static constexpr std::size_t kMostNodes = 256;

    /// Calls `deliver(const link::ReceivedBlock &)` for each message in the next piece of a stream: its path is that of the
    /// piece, in Carrier::Serial. It returns true for a record that was opened. Until a conversation was opened on the stream,
    /// only messages that open one are delivered, by kind and length, and those for which `namesSession(ByteView)` returns
    /// true, since a session continues after its stream was reconnected.
    template<typename NamesSession, typename Deliver>
    void takeCobs(const link::ReceivedBlock &piece, NamesSession &&namesSession, Deliver &&deliver)
    {
        auto &line = m_lines[piece.path];
        if (!line)
            line = std::make_unique<Line>();
        Path path = piece.path;
        path.carrier = Carrier::Serial;
        line->reader.feed(piece.bytes, [&](MutableByteView message) {
            if (!channel::isOurs(message[0]))
                return;
            if (!isRecent(line->talked, piece.time) && !opensConversation(message) && !namesSession(ByteView(message)))
                return;
            line->talked = piece.time;
            if (deliver(link::ReceivedBlock{path, message, piece.time}))
                line->proven = piece.time;
        });
    }

    /// Whether records in COBS were opened on the stream within kBelievedFor.
    bool isCobs(const Path &stream, TimePoint now) const;
    /// A valid MAVLink frame arrived on this stream, so damaged frames there are MAVLink too.
    void noteMavlink(const Path &stream);
    bool speaksMavlink(const Path &stream) const;
    /// Call when a stream begins or ends.
    void forget(const Path &stream) { m_lines.erase(stream); }

    /// Returns true for a TUNNEL frame with the channel's payload type.
    static bool isTunnel(const mavlink::ScanItem &item);
    /// Returns the message that this frame completes, with the path in Carrier::Tunnel of the node that sent it; nullopt if
    /// none is complete or the frame is addressed to another node than `ours`.
    std::optional<link::ReceivedBlock> takeTunnel(TimePoint now, const Path &from, const mavlink::Frame &frame, Node ours);
    /// Returns true for the heartbeat by which an agent behind a router announces its node; it is not telemetry.
    bool isAgentsHeartbeat(const Path &from, const mavlink::Frame &frame) const;

private:
    struct Line
    {
        channel::CobsReader reader;
        TimePoint talked = TimePoint::min(); ///< time of the newest message, or of bytes that resemble one
        TimePoint proven = TimePoint::min(); ///< time of the newest record that was opened
        bool speaksMavlink = false;
    };

    static bool isRecent(TimePoint heard, TimePoint now) { return heard != TimePoint::min() && now < heard + kBelievedFor; }
    static bool opensConversation(ByteView message);

    std::map<Path, std::unique_ptr<Line>> m_lines;
    channel::TunnelReader m_tunnels;
    std::set<Path> m_nodes; ///< nodes that sent messages of the channel
};

} // namespace skyseal::engine
