// Messages of the channel out of what links receive in other carriers than datagrams: COBS frames of a byte stream, and the
// payloads of TUNNEL. Knows as well which streams turned out to be COBS, so that their bytes are not searched for MAVLink.
// I/O thread; no I/O itself.
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
    /// A stream on which no COBS message came for so long may have another speaker by now.
    static constexpr Duration kBelievedFor = std::chrono::seconds(10);
    /// Nodes of routers that are remembered.
    static constexpr std::size_t kMostNodes = 256;

    /// Calls `deliver(const link::ReceivedBlock &)` for each message in the next piece of a stream: its path is that of the
    /// piece, in Carrier::Serial. Until the stream is known to be COBS, only what begins a conversation is taken for a
    /// message, by its kind and length: bytes of MAVLink between two zeros can look like anything else.
    template<typename Deliver> void takeCobs(const link::ReceivedBlock &piece, Deliver &&deliver)
    {
        auto &line = m_lines[piece.path];
        if (!line)
            line = std::make_unique<Line>();
        Path path = piece.path;
        path.carrier = Carrier::Serial;
        line->reader.feed(piece.bytes, [&](MutableByteView message) {
            if (!channel::isOurs(message[0]) || (!isCobs(piece.path, piece.time) && !opensConversation(message)))
                return;
            line->heard = piece.time;
            deliver(link::ReceivedBlock{path, message, piece.time});
        });
    }

    /// Whether messages came in COBS from there of late.
    bool isCobs(const Path &stream, TimePoint now) const;
    /// A whole MAVLink frame came in this stream, so what is damaged there is MAVLink too.
    void noteMavlink(const Path &stream);
    bool speaksMavlink(const Path &stream) const;
    /// A stream begins or ended.
    void forget(const Path &stream) { m_lines.erase(stream); }

    /// True for a frame that may carry a message of ours.
    static bool isTunnel(const mavlink::ScanItem &item);
    /// The message that this frame completes, from the path in Carrier::Tunnel of the node that sent it. nullopt when none
    /// is complete, or it is meant for another node than ours.
    std::optional<link::ReceivedBlock> takeTunnel(TimePoint now, const Path &from, const mavlink::Frame &frame, Node ours);
    /// Whether it is the heartbeat by which an agent behind a router makes itself known: nobody's telemetry.
    bool isAgentsHeartbeat(const Path &from, const mavlink::Frame &frame) const;

private:
    struct Line
    {
        channel::CobsReader reader;
        TimePoint heard = TimePoint::min();
        bool speaksMavlink = false;
    };

    static bool opensConversation(ByteView message);

    std::map<Path, std::unique_ptr<Line>> m_lines;
    channel::TunnelReader m_tunnels;
    std::set<Path> m_nodes; ///< that sent messages of ours
};

} // namespace skyseal::engine
