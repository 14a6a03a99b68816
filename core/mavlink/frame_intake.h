// Extracts MAVLink frames from the blocks that links deliver: the chunks of a stream begin anywhere, so that each remote end
// has its own parser; a datagram holds whole frames as a rule, and the parts of cut ones where a bridge does not regard frames.
// Anybody may send them, so the work for bytes that are not frames is limited. Runs on the thread of its owner; no I/O.
#pragma once

#include "core/base/path.h"
#include "core/mavlink/cut_frames.h"
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

class FrameIntake
{
public:
    /// `dialect` must outlive this object.
    explicit FrameIntake(const Dialect &dialect) : m_dialect(&dialect) {}

    /// Calls `deliver(const ScanItem &)` for every frame and every damaged region of one datagram. A frame that its end cuts is
    /// kept, and delivered or reported as damaged with the next datagram from `from`. Returns false if all bytes were
    /// delivered, true if some were kept, or continued a kept frame.
    template<typename Deliver> bool takeDatagram(TimePoint now, const Path &from, ByteView bytes, Deliver &&deliver)
    {
        CutFrames::Sender *cut = m_cut.find(from);
        const std::size_t begin = cut ? continueCut(now, *cut, bytes, deliver) : 0;
        FrameScanner scanner(bytes.subspan(begin), *m_dialect, BufferEnd::Final, WastedWork::OfDatagram);
        while (auto item = scanner.next()) {
            const bool isCut = !item->frame && item->fault == FrameFault::Truncated
                && scanner.position() == bytes.size() - begin;
            if (isCut && m_cut.keep(now, from, item->bytes))
                return true;
            item->offset += begin;
            deliver(static_cast<const ScanItem &>(*item));
        }
        return begin > 0;
    }
    /// Whether the beginning of a frame of this sender of datagrams is kept.
    bool isCut(const Path &from) { return m_cut.find(from) != nullptr; }

    /// The same for the next piece of the byte stream from `from`. An incomplete frame is kept until its end arrives.
    template<typename Deliver> void takeStream(const Path &from, ByteView bytes, Deliver &&deliver)
    {
        auto &parser = m_streams[from];
        if (!parser)
            parser = std::make_unique<StreamParser>(*m_dialect);
        parser->feed(bytes, deliver);
    }

    /// Drops the incomplete frame of a stream. Call it when a stream begins or ends.
    void forget(const Path &from)
    {
        m_streams.erase(from);
        m_cut.forget(from);
    }

private:
    /// Reads the kept beginning of a frame together with the datagram. Returns the number of its bytes that belong to the
    /// frame: 0 if there is no such frame, all if it does not end here either.
    template<typename Deliver> std::size_t continueCut(TimePoint now, CutFrames::Sender &cut, ByteView bytes, Deliver &&deliver)
    {
        std::array<std::uint8_t, CutFrames::kLongest + kMaxFrameLength> buffer;
        const std::size_t kept = cut.kept, added = std::min(bytes.size(), kMaxFrameLength);
        std::copy_n(m_cut.begin(cut).data(), kept, buffer.data());
        std::copy_n(bytes.data(), added, buffer.data() + kept);
        const ByteView joined(buffer.data(), kept + added);
        FrameScanner scanner(joined, *m_dialect, BufferEnd::Final, WastedWork::OfDatagram);
        while (auto item = scanner.next()) {
            if (item->offset >= kept)
                break;
            const std::size_t end = scanner.position();
            if (isWholeFrame(*item) && end > kept) {
                item->offset = 0;
                deliver(static_cast<const ScanItem &>(*item));
                if (item->frame)
                    m_cut.completed(now, cut);
                else
                    m_cut.failed(cut); // nothing proves that an unknown message is one
                return end - kept;
            }
            if (item->fault == FrameFault::Truncated && end == joined.size() && added == bytes.size()) {
                m_cut.extend(now, cut, item->bytes);
                return bytes.size();
            }
        }
        deliver(ScanItem{std::nullopt, FrameFault::Truncated, 0, joined.first(kept)});
        m_cut.failed(cut);
        return 0;
    }

    const Dialect *m_dialect;
    CutFrames m_cut;
    std::map<Path, std::unique_ptr<StreamParser>> m_streams;
};

} // namespace skyseal::mavlink
