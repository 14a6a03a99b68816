// The payload of FILE_TRANSFER_PROTOCOL. https://mavlink.io/en/services/ftp.html
#pragma once

#include "core/base/bytes.h"
#include "core/vehicle/remote_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

enum class FtpOpcode : std::uint8_t {
    TerminateSession = 1,
    ResetSessions = 2,
    ListDirectory = 3,
    OpenFileRO = 4,
    ReadFile = 5,
    CreateFile = 6,
    WriteFile = 7,
    RemoveFile = 8,
    CalcFileCRC32 = 14,
    BurstReadFile = 15,
    Ack = 128,
    Nak = 129
};

enum class FtpError : std::uint8_t {
    Fail = 1,
    FailErrno = 2,
    InvalidDataSize = 3,
    InvalidSession = 4,
    NoSessionsAvailable = 5,
    EndOfFile = 6,
    UnknownCommand = 7,
    FileExists = 8,
    FileProtected = 9,
    FileNotFound = 10
};

struct FtpMessage
{
    static constexpr std::size_t kSize = 251, kHeader = 12, kMostData = kSize - kHeader;

    std::uint16_t sequence = 0;
    std::uint8_t session = 0;
    FtpOpcode opcode{};
    std::uint8_t size = 0; ///< bytes of the data, or to be read
    FtpOpcode requested{}; ///< what an answer answers
    bool burstComplete = false;
    std::uint32_t offset = 0;
    std::array<std::uint8_t, kMostData> data{};

    static FtpMessage decode(const std::array<std::uint8_t, kSize> &payload);
    std::array<std::uint8_t, kSize> encode() const;

    /// The data, at most kMostData bytes whatever the size says.
    ByteView view() const { return {data.data(), std::min<std::size_t>(size, kMostData)}; }
    void setData(ByteView bytes);
    /// Of a Nak; nullopt of other messages.
    std::optional<FtpError> error() const;
};

/// For people: "no such file", …; of FailErrno with the number that the vehicle sends.
std::string ftpErrorText(const FtpMessage &nak);

/// One part of a directory.
struct FtpListing
{
    std::vector<RemoteFile> entries; ///< with printable names
    std::uint32_t count = 0;         ///< entries in the message, those that are skipped included
};
FtpListing parseListing(ByteView data);

/// CRC-32 of the protocol: polynomial 0x04C11DB7 reflected, starting with 0 and without a final inversion.
std::uint32_t ftpChecksum(ByteView bytes, std::uint32_t crc = 0);

} // namespace skyseal::vehicle
