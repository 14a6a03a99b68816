// The file server of the simulated vehicle, which takes paths, offsets and parameter files from anybody: whatever is requested,
// in any order and at any time, it stays within its memory, and every answer is a well-formed one to a request that was sent.
#include "core/base/byte_reader.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_reader.h"
#include "core/sim/ftp_server.h"

#include <cstdlib>

using namespace skyseal;
using namespace skyseal::sim;

namespace {

void expect(bool holds)
{
    if (!holds)
        std::abort();
}

void checkAnswers(FrameQueue &outbox)
{
    for (ByteView bytes = outbox.poll(); !bytes.empty(); bytes = outbox.poll()) {
        const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
        expect(frame && frame->messageId() == mavlink::FileTransferProtocol::kId);
        const auto reply = FtpMessage::decode(mavlink::FileTransferProtocol::decode(frame->payload()).payload);
        expect(reply.size <= FtpMessage::kMostData);
        expect(reply.opcode == mavlink::MAV_FTP_OPCODE_ACK
               || (reply.opcode == mavlink::MAV_FTP_OPCODE_NAK && (reply.size == 1 || reply.size == 2)));
        expect(reply.requested != mavlink::MAV_FTP_OPCODE_ACK && reply.requested != mavlink::MAV_FTP_OPCODE_NAK);
    }
}

void checkParameters(const Parameters &parameters)
{
    for (std::size_t i = 0; i < parameters.count(); ++i)
        expect(parameters.value(i) >= parameters.info(i).minimum && parameters.value(i) <= parameters.info(i).maximum);
}

} // namespace

/// A sequence of requests, each of: milliseconds since the last (tens), station, length of the data, header without padding
/// (sequence 8 bits, session, opcode, size, offset 32 bits), data.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ByteReader in(ByteView(data, size));
    Autopilot autopilot({});
    FileStore card;
    FlightLogs logs;
    logs.begin(1'700'000'000);
    logs.append(asBytes("a log"));
    FrameQueue outbox(1);
    VehicleFiles files(card, logs, autopilot);
    FtpServer server(files, outbox);
    TimePoint now{};
    while (!in.atEnd() && in.ok()) {
        now += std::chrono::milliseconds(10 * in.u8());
        const FrameSender peer{static_cast<std::uint8_t>(in.u8() % 8), 190, 2};
        const std::size_t length = in.u8();
        FtpMessage request;
        request.sequence = in.u8();
        request.session = in.u8();
        request.opcode = in.u8();
        const std::uint8_t claimed = in.u8();
        request.offset = in.u32();
        request.append(in.bytes(std::min({length, in.remaining(), FtpMessage::kMostData})));
        request.size = claimed;
        server.handleDeadline(now);
        server.handle(now, peer, request);
        checkAnswers(outbox);
        expect(server.openSessions() <= FtpServer::kSessions);
        expect(card.bytes() <= FileStore::kMostBytes && card.nodes() <= FileStore::kMostNodes);
    }
    now += std::chrono::seconds(5);
    server.handleDeadline(now);
    checkAnswers(outbox);
    checkParameters(autopilot.parameters());
    return 0;
}
