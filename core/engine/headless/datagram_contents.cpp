#include "core/engine/headless/datagram_contents.h"

#include "core/channel/inline_frame.h"
#include "core/channel/record.h"
#include "core/mavlink/frame_reader.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

/// The length of the frame at the front of `bytes`; 0 if there is none or it is truncated.
std::size_t wholeFrameLength(ByteView bytes)
{
    const std::size_t length = mavlink::frameLength(bytes);
    return length <= bytes.size() ? length : 0;
}

} // namespace

std::uint64_t DatagramContents::clearFrames() const
{
    return static_cast<std::uint64_t>(
        std::count_if(frames.begin(), frames.end(), [](const Frame &frame) { return !frame.sealedInPlace; }));
}

DatagramContents contentsOf(ByteView datagram)
{
    DatagramContents out;
    if (const auto record = channel::RecordHeader::read(datagram); record && record->kind == channel::DatagramKind::Record) {
        out.connection = static_cast<std::uint16_t>(record->connection);
        out.epoch = record->epochBits;
        out.counters.push_back(record->counter);
        return out;
    }
    while (const std::size_t length = wholeFrameLength(datagram)) {
        if (datagram[0] == mavlink::kMagic1)
            out.frames.push_back({datagram[3], datagram[4], datagram[2], false});
        else
            out.frames.push_back({datagram[5], datagram[6], datagram[4], datagram[2] == channel::kInlineFlags});
        if (out.frames.back().sealedInPlace) {
            const ByteView trailer = datagram.first(length).last(channel::kInlineTrailer);
            out.epoch = trailer[0] & 3;
            out.counters.push_back(trailer[1] | trailer[2] << 8u | trailer[3] << 16u | std::uint32_t{trailer[4]} << 24);
        }
        datagram = datagram.subspan(length);
    }
    return out;
}

} // namespace skyseal::engine
