#include "core/link/datagram_contents.h"

#include "core/channel/inline_frame.h"
#include "core/channel/record.h"

#include <algorithm>

namespace skyseal::link {

namespace {

constexpr std::uint8_t kMagic1 = 0xfe, kMagic2 = 0xfd;
constexpr std::size_t kHeader1 = 6, kHeader2 = 10, kChecksum = 2;
constexpr std::uint8_t kIsSigned = 0x01;

/// The length of the frame at the front of `bytes`; 0 when there is none or it is truncated.
std::size_t frameLength(ByteView bytes)
{
    std::size_t length = 0;
    if (bytes.size() > kHeader1 && bytes[0] == kMagic1)
        length = kHeader1 + bytes[1] + kChecksum;
    else if (bytes.size() > kHeader2 && bytes[0] == kMagic2)
        length = kHeader2 + bytes[1] + kChecksum + ((bytes[2] & kIsSigned) != 0 ? channel::kInlineTrailer : 0);
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
    while (const std::size_t length = frameLength(datagram)) {
        if (datagram[0] == kMagic1)
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

} // namespace skyseal::link
