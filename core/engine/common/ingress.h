// Classifies received blocks: a message of the pairing, a record of the channel, a frame sealed in place, a part of a
// TUNNEL message, a COBS frame, or clear MAVLink. The station and the agent use the same class; each link is registered with
// the sink of its user and with rules that are made once, when the link opens, so that no property of a link is
// checked per packet. I/O thread; no I/O itself. Allocates only when a stream begins.
//
// Specification of the carriers: core/channel/PROTOCOL.md, sections on carriers and on frames sealed in place.
#pragma once

#include "core/engine/common/carrier_reader.h"
#include "core/engine/common/carrier_writer.h"
#include "core/link/link.h"
#include "core/mavlink/frame_intake.h"

#include <map>

namespace skyseal::engine {

/// Whether the bytes of a link are searched for clear MAVLink.
enum class ClearScan : std::uint8_t {
    Never,
    UnlessCobs, ///< not in a stream on which records in COBS are opened
    Always
};

/// Interpretation of the blocks of one link.
struct IngressRules
{
    bool isStream = false;            ///< blocks are pieces of a byte stream; otherwise each is a datagram
    bool takesDatagrams = false;      ///< a datagram may be a message of the channel, or hold frames sealed in place
    bool sealed = false;              ///< records are opened, which is not so on plain links that only take pairings
    bool takesCobs = false;           ///< the stream may hold messages of the channel in COBS
    bool takesTunnel = false;         ///< TUNNEL frames may carry messages of the channel
    bool dropsNodeHeartbeats = false; ///< the clear heartbeat of an agent behind a router is not telemetry
    ClearScan clear = ClearScan::Always;

    bool operator==(const IngressRules &) const = default;
};

/// Reason why a datagram or message was not usable.
enum class Unusable : std::uint8_t {
    Garbage, ///< a datagram without anything that resembles a frame
    Clear,   ///< a datagram that begins like MAVLink, on a link whose bytes are not searched for it
    Damaged, ///< a datagram whose frames are all damaged or of an unknown kind, or one that holds part of a frame
    Message  ///< a message in TUNNEL that does not belong to the channel
};

/// Receives the classified blocks of one link. The blocks and frames are valid during the call.
class IngressSink
{
public:
    virtual ~IngressSink() = default;
    /// Returns false if the message is not one of a pairing that is in progress.
    virtual bool takePairing(const link::Link &, const link::ReceivedBlock & /*message*/) { return false; }
    /// Returns true if the message is a record of a session on a serial carrier, by its connection id.
    virtual bool namesSession(ByteView /*message*/) const { return false; }
    /// A message whose first byte belongs to the channel; the path has the carrier in which it arrived. Returns true if it is a
    /// record that was opened.
    virtual bool takeRecord(const link::Link &, const link::ReceivedBlock & /*message*/) { return false; }
    /// `frame` is a single frame, to be opened in place.
    virtual void takeSealedInPlace(const link::Link &, const link::ReceivedBlock & /*frame*/) {}
    /// A frame in clear, or a region without a readable frame.
    virtual void takeClear(const link::Link &, const link::ReceivedBlock &block, const mavlink::ScanItem &item) = 0;
    virtual void takeUnusable(const link::Link &, Unusable) {}
};

class Ingress
{
public:
    /// `carriers` holds the node to which TUNNEL messages must be addressed; it and `dialect` must outlive this object.
    Ingress(const mavlink::Dialect &dialect, const CarrierWriter &carriers) : m_frames(dialect), m_carriers(carriers) {}

    /// `sink` must outlive the link.
    void addLink(LinkId id, const IngressRules &rules, IngressSink &sink) { m_links[id] = {rules, &sink}; }
    /// Takes effect from the next message on, also from within a call of the sink.
    void setRules(LinkId id, const IngressRules &rules);
    /// As setRules(), but not from within a call of the sink.
    void setSink(LinkId id, IngressSink &sink);
    void removeLink(LinkId id) { m_links.erase(id); }

    /// Passes the block to the sink of its link; blocks of unregistered links are dropped.
    void take(const link::Link &link, const link::ReceivedBlock &block);
    /// A stream begins or ends: partial frames of the old one are dropped.
    void forget(const Path &stream);
    /// Whether records in COBS were opened on this stream within the last 10 s.
    bool isCobs(const Path &stream, TimePoint now) const { return m_reader.isCobs(stream, now); }

private:
    struct Registered
    {
        IngressRules rules;
        IngressSink *sink = nullptr;
    };

    void takeStream(const Registered &to, const link::Link &link, const link::ReceivedBlock &block);
    void takeDatagram(const Registered &to, const link::Link &link, const link::ReceivedBlock &block);
    bool takeTunnel(const Registered &to, const link::Link &link, const link::ReceivedBlock &block,
                    const mavlink::ScanItem &item);
    static bool takeMessage(IngressSink &sink, const link::Link &link, const link::ReceivedBlock &message);

    std::map<LinkId, Registered> m_links;
    mavlink::FrameIntake m_frames;
    CarrierReader m_reader;
    const CarrierWriter &m_carriers;
};

} // namespace skyseal::engine
