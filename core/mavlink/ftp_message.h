// Payload of FILE_TRANSFER_PROTOCOL, and the checksum of its files. Opcodes and errors are those of the dialect
// (MAV_FTP_OPCODE, MAV_FTP_ERR). https://mavlink.io/en/services/ftp.html, payload format; the checksum as PX4's
// mavlink_ftp.cpp and ArduPilot's AP_Filesystem::crc32() compute it.
#pragma once

#include "core/base/bytes.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace skyseal::mavlink {

struct FtpMessage
{
    static constexpr std::size_t kMostData = 239;
    using Payload = decltype(FileTransferProtocol::payload);

    std::uint16_t sequence = 0;
    std::uint8_t session = 0;
    std::uint8_t opcode = 0;    ///< MAV_FTP_OPCODE
    std::uint8_t size = 0;      ///< of the data, or the number of bytes to read; up to 255 in a received message
    std::uint8_t requested = 0; ///< in an answer: the opcode of the request
    bool burstComplete = false;
    std::uint32_t offset = 0;
    std::array<std::uint8_t, kMostData> data{};

    static FtpMessage decode(const Payload &payload);
    Payload encode() const;

    /// The data that `size` counts, at most kMostData bytes.
    ByteView content() const { return ByteView(data).first(std::min<std::size_t>(size, data.size())); }
    /// Appends to the data. Returns false, and appends nothing, if it does not fit.
    bool append(ByteView bytes);
    bool appendNumber(std::uint32_t value);
    /// The number at the start of the data: a size or a checksum. nullopt if there is none.
    std::optional<std::uint32_t> number() const;
    /// MAV_FTP_ERR of a refusal; nullopt of other messages.
    std::optional<std::uint8_t> error() const;
    /// Makes this answer a refusal.
    void refuse(MAV_FTP_ERR error);
};

/// CRC-32 of the protocol: polynomial 0x04C11DB7 reflected, starting with 0 and without a final inversion. For a file in parts,
/// pass the checksum of the preceding parts.
std::uint32_t ftpChecksum(ByteView bytes, std::uint32_t checksum = 0);

} // namespace skyseal::mavlink
