// An unsealed HEARTBEAT, which needs no key.
#pragma once

#include "core/base/bytes.h"
#include "core/mavlink/crc.h"

#include <QtCore/QByteArray>

#include <cstdint>

namespace skyseal::test {

/// MAVLink 1, of an ArduPilot multicopter.
inline QByteArray clearHeartbeat(std::uint8_t systemId, std::uint8_t componentId, bool armed)
{
    static constexpr std::uint8_t kCrcExtra = 50;
    QByteArray frame = QByteArray::fromHex("fe0900010100000000000203");
    frame[3] = static_cast<char>(systemId);
    frame[4] = static_cast<char>(componentId);
    frame.append(static_cast<char>(armed ? 0x81 : 0x01)).append('\x04').append('\x03');
    const ByteView covered(reinterpret_cast<const std::uint8_t *>(frame.constData()) + 1,
                           static_cast<std::size_t>(frame.size()) - 1);
    const std::uint16_t crc = mavlink::crcAccumulate(mavlink::crcAccumulate(mavlink::kCrcStart, covered), {&kCrcExtra, 1});
    return frame.append(static_cast<char>(crc & 0xFF)).append(static_cast<char>(crc >> 8));
}

/// A .tlog of so many of them, all of one moment.
inline QByteArray recordedHeartbeats(std::uint8_t systemId, int count)
{
    return (QByteArray::fromHex("0005f5e100000000") + clearHeartbeat(systemId, 1, false)).repeated(count);
}

} // namespace skyseal::test
