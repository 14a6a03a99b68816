#include "core/engine/headless/self_test.h"

#include "core/base/hex.h"
#include "core/mavlink/crc.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/frame.h"
#include "core/mavlink/messages.h"

#include <iterator>

namespace skyseal::engine {

std::vector<SelfTest> mavlinkSelfTests()
{
    const auto crc = []() -> std::optional<std::string> {
        // The check value of CRC-16/MCRF4XX in the catalogue of parametrised CRC algorithms.
        if (mavlink::crcAccumulate(mavlink::kCrcStart, asBytes("123456789")) != 0x6f91)
            return "wrong checksum";
        return std::nullopt;
    };
    const auto frame = []() -> std::optional<std::string> {
        // A HEARTBEAT of system 15, component 27, as the reference implementation packs it.
        const Bytes bytes = fromHex("fd090000010f1b000000221e0769f237925b0352fa").value_or(Bytes());
        const auto read = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
        if (!read)
            return "a known frame is refused: " + std::string(mavlink::nameOf(read.error().fault));
        if (read->messageId() != mavlink::Heartbeat::kId || read->systemId() != 15)
            return "a known frame is read wrongly";
        Bytes damaged = bytes;
        damaged[12] ^= 1;
        if (mavlink::readFrame(damaged, mavlink::Dialect::builtin()))
            return "a damaged frame is taken";
        return std::nullopt;
    };
    return {{"MAVLink checksum", crc}, {"MAVLink frame", frame}};
}

std::vector<SelfTest> selfTests()
{
    std::vector<SelfTest> out;
    for (auto *part : {primitiveSelfTests, suiteSelfTests, handshakeSelfTests, mavlinkSelfTests, sessionSelfTests}) {
        auto tests = part();
        std::move(tests.begin(), tests.end(), std::back_inserter(out));
    }
    return out;
}

} // namespace skyseal::engine
