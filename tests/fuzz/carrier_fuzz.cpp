// The codecs of the carriers, which take bytes from anybody: whatever comes, they stay within their memory, a COBS frame
// that is read and written again is read as the same message, and what was written is always found behind garbage.
#include "core/base/byte_reader.h"
#include "core/channel/cobs.h"
#include "core/channel/tunnel_parts.h"

#include <algorithm>
#include <cstdlib>

using namespace skyseal;
using namespace skyseal::channel;

namespace {

void expect(bool holds)
{
    if (!holds)
        std::abort();
}

void readLine(ByteView line)
{
    CobsReader reader;
    std::array<std::uint8_t, kMaxCobs> frame;
    const auto check = [&](MutableByteView message) {
        expect(!message.empty() && message.size() <= kMaxDatagram);
        const std::size_t size = writeCobs(message, frame);
        expect(size > 0 && size <= frame.size() && frame[size - 1] == 0);
        CobsReader again;
        std::size_t found = 0;
        again.feed(ByteView(frame).first(size), [&](MutableByteView read) {
            ++found;
            expect(std::equal(read.begin(), read.end(), message.begin(), message.end()));
        });
        expect(found == 1);
    };
    // In pieces of every size.
    for (std::size_t piece = 1; !line.empty(); piece = piece * 2 + 1) {
        const ByteView now = line.first(std::min(piece, line.size()));
        reader.feed(now, check);
        line = line.subspan(now.size());
    }
    // The line has a zero now and then: the message after it is whole.
    const std::array<std::uint8_t, 5> message{0x54, 0, 1, 0, 0xff};
    const std::size_t size = writeCobs(message, frame);
    std::size_t found = 0;
    const auto count = [&](MutableByteView read) {
        found += std::equal(read.begin(), read.end(), message.begin(), message.end());
    };
    const std::array<std::uint8_t, 1> zero{};
    reader.feed(zero, [](MutableByteView) {});
    reader.feed(ByteView(frame).first(size), count);
    expect(found == 1);
}

void readPayloads(ByteReader &in)
{
    TunnelReader reader;
    TimePoint now{std::chrono::seconds(1)};
    while (!in.atEnd() && in.ok()) {
        const std::uint8_t sender = in.u8();
        const ByteView payload = in.bytes(std::min<std::size_t>(in.u8(), in.remaining()));
        now += std::chrono::milliseconds(sender);
        const Path path{LinkId{1}, {}, Carrier::Tunnel, {sender, 191}};
        const auto message = reader.take(now, path, payload);
        if (!message)
            continue;
        expect(!message->empty() && message->size() <= kMaxTunnelled);
        std::size_t whole = 0;
        TunnelReader again;
        expect(writeParts(*message, 7, [&](ByteView part) {
            expect(part.size() <= kTunnelPayload);
            if (const auto read = again.take(now, path, part)) {
                ++whole;
                expect(std::equal(read->begin(), read->end(), message->begin(), message->end()));
            }
        }));
        expect(whole == (isOurs((*message)[0]) || message->size() > kTunnelPayload ? 1u : 0u));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ByteReader in(ByteView(data, size));
    if (in.u8() % 2 == 0)
        readLine(in.bytes(in.remaining()));
    else
        readPayloads(in);
    return 0;
}
