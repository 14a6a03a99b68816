// Payload of FILE_TRANSFER_PROTOCOL (https://mavlink.io/en/services/ftp.html, payload format).
#pragma once

#include "core/base/bytes.h"
#include "core/mavlink/messages.h"

#include <algorithm>
#include <array>

namespace skyseal::sim {

struct FtpMessage
{
    static constexpr std::size_t kMostData = 239;
    using Payload = decltype(mavlink::FileTransferProtocol::payload);

    std::uint16_t sequence = 0;
    std::uint8_t session = 0;
    std::uint8_t opcode = 0; ///< MAV_FTP_OPCODE
    std::uint8_t size = 0;   ///< of the data, or how much is to be read; up to 255 in a received message
    std::uint8_t requestOpcode = 0;
    bool burstComplete = false;
    std::uint32_t offset = 0;
    std::array<std::uint8_t, kMostData> data{};

    static FtpMessage decode(const Payload &payload);
    Payload encode() const;

    /// The data that `size` counts.
    ByteView content() const { return ByteView(data).first(std::min<std::size_t>(size, data.size())); }
    /// Appends to the data; false, and nothing is appended, if it does not fit.
    bool append(ByteView bytes);
};

} // namespace skyseal::sim
