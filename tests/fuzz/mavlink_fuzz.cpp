// Any bytes as a datagram, as a stream in portions, as a recording, and as the file with link events beside it. What comes out
// must cover what went in, and every valid frame must be told as JSON and encode again to its own bytes. The index of the
// recording must be sound, and every link event must be written as the line that it was.
#include "core/log/decode.h"
#include "core/log/log_index.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/message_json.h"
#include "core/mavlink/payload_builder.h"
#include "core/mavlink/stream_parser.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <vector>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

void require(bool condition)
{
    if (!condition)
        std::abort();
}

/// The length of a payload in MAVLink 2: without the zeros at its end, but at least one byte.
std::size_t trimmedLength(ByteView payload)
{
    std::size_t length = payload.size();
    while (length > 1 && payload[length - 1] == 0)
        --length;
    return length;
}

void encodeAgain(const Frame &frame)
{
    const ByteView payload = frame.payload();
    const bool isWhole = frame.version() == 2
        ? payload.size() <= frame.info().maxLength && !payload.empty() && trimmedLength(payload) == payload.size()
        : payload.size() == frame.info().minLength;
    if (!isWhole)
        return;
    PayloadBuilder builder(frame.info());
    for (const FieldInfo &field : frame.info().fields) {
        for (std::size_t i = 0; i < field.elements(); ++i)
            require(builder.set(field, i, fieldValue(payload, field, i)));
    }
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const auto again = writeFrame(buffer, frame.version(), frame.sequence(), frame.systemId(), frame.componentId(),
                                  frame.messageId(), frame.info().crcExtra, frame.info().minLength, builder.payload(),
                                  frame.incompatFlags());
    const ByteView bytes = frame.bytes();
    const std::size_t compared = bytes.size() - (frame.isSigned() ? kSignatureLength : 0);
    // The compatibility flags of a received frame may be any, ours are 0: then the checksums differ as well.
    if (frame.version() == 1 || bytes[3] == 0)
        require(again.size() == bytes.size()
                && std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(compared), again.begin()));
}

tlog::LinkEvents readEventsAgain(ByteView bytes)
{
    std::istringstream input(std::string(asText(bytes)));
    tlog::LinkEvents out = tlog::readLinkEvents(input);
    require(out.events.size() <= tlog::LinkEvents::kMost && out.events.size() + out.unreadable <= bytes.size());
    for (const tlog::LinkEvent &event : out.events) {
        const std::string line = tlog::lineOf(event);
        require(tlog::linkEventOf(std::string_view(line).substr(0, line.size() - 1)) == event);
    }
    return out;
}

/// Every position of an index lies on its time line, in order, and its lists are bounded.
void indexAgain(ByteView bytes)
{
    std::istringstream input(std::string(asText(bytes)));
    const tlog::LinkEvents events = readEventsAgain(bytes);
    const tlog::LogIndex index = tlog::indexOf(input, events);
    const auto isOnLine = [&](const tlog::LogSpan &span) {
        return Duration::zero() <= span.from && span.from <= span.to && span.to <= index.length;
    };
    for (const tlog::LogSpan &gap : index.gaps)
        require(isOnLine(gap) && gap.to - gap.from > tlog::LogIndex::kGap);
    for (const tlog::ArmedSpan &armed : index.armed)
        require(isOnLine(armed.span));
    for (const tlog::ModeChange &mode : index.modes)
        require(isOnLine({mode.at, mode.at}));
    for (const tlog::SuiteMark &mark : index.suites)
        require(isOnLine({mark.at, mark.at}));
    require(index.suites.size() == std::min(events.events.size(), tlog::LogIndex::kListed));
    require(index.gaps.size() <= tlog::LogIndex::kListed && index.armed.size() <= tlog::LogIndex::kListed);
    require(index.modes.size() <= tlog::LogIndex::kListed && index.vehicles.size() <= 255);
    require(index.first || (index.length == Duration::zero() && index.gaps.empty()));
    require(index.frames + index.damaged <= bytes.size());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const ByteView bytes(data, size);
    std::vector<std::size_t> found;
    std::size_t covered = 0;
    JsonWriter json;
    FrameScanner scanner(bytes, Dialect::builtin());
    while (const auto item = scanner.next()) {
        require(item->offset == covered && !item->bytes.empty());
        covered += item->bytes.size();
        if (!item->frame)
            continue;
        found.push_back(item->offset);
        json.clear();
        writeMessageJson(json, *item->frame);
        encodeAgain(*item->frame);
    }
    require(covered == size);
    require(scanner.crcBytes() <= size + OverlappingCrc::kLongestRange);

    const std::size_t portion = size > 0 ? 1 + data[0] % 64u : 1;
    std::size_t frames = 0;
    covered = 0;
    const auto note = [&](const ScanItem &item) {
        require(item.offset == covered);
        covered += item.bytes.size();
        frames += item.frame.has_value();
    };
    StreamParser parser(Dialect::builtin());
    for (std::size_t at = 0; at < size; at += portion)
        parser.feed(bytes.subspan(at, std::min(portion, size - at)), note);
    parser.finish(note);
    require(covered == size && frames == found.size());
    require(parser.crcBytes() <= size + OverlappingCrc::kLongestRange);

    std::istringstream input(std::string(asText(bytes)));
    tlog::decode(input, Dialect::builtin(), {}, [](std::string_view) { return true; });
    indexAgain(bytes);
    return 0;
}
