// Frames out of what links deliver: a datagram holds whole frames, a stream is cut anywhere and keeps a parser for each
// peer. I/O thread.
#pragma once

#include "core/base/path.h"
#include "core/channel/endpoint.h"
#include "core/mavlink/stream_parser.h"

#include <map>
#include <memory>

namespace skyseal::engine {

class FrameIntake
{
public:
    explicit FrameIntake(const mavlink::Dialect &dialect) : m_dialect(&dialect) {}

    /// Calls `deliver(const mavlink::ScanItem &)` for every frame and every damaged spot.
    template<typename Deliver> void takeDatagram(ByteView bytes, Deliver &&deliver)
    {
        mavlink::FrameScanner scanner(bytes, *m_dialect);
        while (const auto item = scanner.next())
            deliver(*item);
    }

    template<typename Deliver> void takeStream(const Path &from, ByteView bytes, Deliver &&deliver)
    {
        auto &parser = m_streams[from];
        if (!parser)
            parser = std::make_unique<mavlink::StreamParser>(*m_dialect);
        parser->feed(bytes, deliver);
    }

    /// A stream begins or ended: half a frame of the old one is no beginning for the new one.
    void forget(const Path &from) { m_streams.erase(from); }

private:
    const mavlink::Dialect *m_dialect;
    std::map<Path, std::unique_ptr<mavlink::StreamParser>> m_streams;
};

/// True for a whole frame that claims to be sealed in place: no frame for anybody but the channel.
inline bool isSealedInPlace(const mavlink::ScanItem &item)
{
    const bool whole = item.fault == mavlink::FrameFault::UnknownIncompatFlags
        || item.fault == mavlink::FrameFault::UnknownMessage;
    return !item.frame && whole && channel::Endpoint::ownsFrame(item.bytes);
}

/// True when the damaged spot was a frame with a wrong checksum or cut short; noise between frames (the console text of an
/// autopilot that boots) is not counted as damage.
inline bool isDamagedFrame(const mavlink::ScanItem &item)
{
    return !item.frame && (item.fault == mavlink::FrameFault::BadCrc || item.fault == mavlink::FrameFault::Truncated);
}

} // namespace skyseal::engine
