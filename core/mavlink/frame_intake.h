// Extracts MAVLink frames from the blocks that links deliver: a datagram holds whole frames; the chunks of a stream
// begin anywhere, so that each remote end has its own parser. Anybody may send them, so the work for bytes that are not frames
// is limited. Runs on the thread of its owner; no I/O and no clock.
#pragma once

#include "core/base/path.h"
#include "core/mavlink/stream_parser.h"

#include <map>
#include <memory>

namespace skyseal::mavlink {

/// Calls `deliver(const ScanItem &)` for every frame and every damaged region of a buffer of whole frames.
template<typename Deliver>
void scanFrames(ByteView bytes, const Dialect &dialect, Deliver &&deliver, WastedWork limit = WastedWork::Unlimited)
{
    FrameScanner scanner(bytes, dialect, BufferEnd::Final, limit);
    while (const auto item = scanner.next())
        deliver(*item);
}

class FrameIntake
{
public:
    /// `dialect` must outlive this object.
    explicit FrameIntake(const Dialect &dialect) : m_dialect(&dialect) {}

    /// scanFrames() for one datagram.
    template<typename Deliver> void takeDatagram(ByteView bytes, Deliver &&deliver)
    {
        scanFrames(bytes, *m_dialect, deliver, WastedWork::OfDatagram);
    }

    /// The same for the next piece of the byte stream from `from`. An incomplete frame is kept until its end arrives.
    template<typename Deliver> void takeStream(const Path &from, ByteView bytes, Deliver &&deliver)
    {
        auto &parser = m_streams[from];
        if (!parser)
            parser = std::make_unique<StreamParser>(*m_dialect);
        parser->feed(bytes, deliver);
    }

    /// Drops the incomplete frame of a stream. Call it when a stream begins or ends.
    void forget(const Path &from) { m_streams.erase(from); }

private:
    const Dialect *m_dialect;
    std::map<Path, std::unique_ptr<StreamParser>> m_streams;
};

/// True for a frame with a wrong checksum or a truncated one. Noise between frames, such as the console output of a booting
/// autopilot, does not count as damage.
inline bool isDamagedFrame(const ScanItem &item)
{
    return !item.frame && (item.fault == FrameFault::BadCrc || item.fault == FrameFault::Truncated);
}

/// True for a valid frame, and for a frame of an unknown message, which can be forwarded unchanged.
inline bool isWholeFrame(const ScanItem &item)
{
    return item.frame || item.fault == FrameFault::UnknownMessage;
}

} // namespace skyseal::mavlink
