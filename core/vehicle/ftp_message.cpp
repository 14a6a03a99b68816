#include "core/vehicle/ftp_message.h"

#include "core/base/byte_reader.h"
#include "core/base/printable.h"

#include <algorithm>
#include <charconv>

namespace skyseal::vehicle {

namespace {

constexpr auto kCrcTable = [] {
    std::array<std::uint32_t, 256> out{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> 1) ^ ((value & 1) ? 0xEDB88320u : 0u);
        out[i] = value;
    }
    return out;
}();

/// "Fname\tsize", "Dname"; nullopt for others, such as "S" for an entry that is skipped.
std::optional<RemoteFile> entryIn(std::string_view text)
{
    if (text.size() < 2 || (text[0] != 'F' && text[0] != 'D'))
        return std::nullopt;
    RemoteFile out;
    out.isFolder = text[0] == 'D';
    const std::size_t tab = text.find('\t');
    out.name = printable(text.substr(1, tab == std::string_view::npos ? tab : tab - 1));
    if (tab != std::string_view::npos && !out.isFolder)
        std::from_chars(text.data() + tab + 1, text.data() + text.size(), out.size);
    return out;
}

} // namespace

FtpMessage FtpMessage::decode(const std::array<std::uint8_t, kSize> &payload)
{
    ByteReader reader(payload);
    FtpMessage out;
    out.sequence = reader.u16();
    out.session = reader.u8();
    out.opcode = static_cast<FtpOpcode>(reader.u8());
    out.size = reader.u8();
    out.requested = static_cast<FtpOpcode>(reader.u8());
    out.burstComplete = reader.u8() != 0;
    reader.u8();
    out.offset = reader.u32();
    std::ranges::copy(reader.rest(), out.data.begin());
    return out;
}

std::array<std::uint8_t, FtpMessage::kSize> FtpMessage::encode() const
{
    std::array<std::uint8_t, kSize> out{};
    out[0] = static_cast<std::uint8_t>(sequence);
    out[1] = static_cast<std::uint8_t>(sequence >> 8);
    out[2] = session;
    out[3] = static_cast<std::uint8_t>(opcode);
    out[4] = size;
    out[5] = static_cast<std::uint8_t>(requested);
    out[6] = burstComplete;
    for (std::size_t i = 0; i < 4; ++i)
        out[8 + i] = static_cast<std::uint8_t>(offset >> (8 * i));
    std::ranges::copy(data, out.begin() + kHeader);
    return out;
}

void FtpMessage::setData(ByteView bytes)
{
    const ByteView taken = bytes.first(std::min(bytes.size(), kMostData));
    std::ranges::copy(taken, data.begin());
    size = static_cast<std::uint8_t>(taken.size());
}

std::optional<FtpError> FtpMessage::error() const
{
    if (opcode != FtpOpcode::Nak)
        return std::nullopt;
    return size > 0 ? static_cast<FtpError>(data[0]) : FtpError::Fail;
}

std::string ftpErrorText(const FtpMessage &nak)
{
    const FtpError error = nak.error().value_or(FtpError::Fail);
    switch (error) {
    case FtpError::Fail: return "the vehicle reports a failure";
    case FtpError::FailErrno:
        if (nak.size > 1 && nak.data[1] == 2)
            return "no such file or folder";
        return "the vehicle reports error " + std::to_string(nak.size > 1 ? nak.data[1] : 0);
    case FtpError::InvalidDataSize: return "the vehicle refuses the size";
    case FtpError::InvalidSession: return "the vehicle has closed the file";
    case FtpError::NoSessionsAvailable: return "too many files are open on the vehicle";
    case FtpError::EndOfFile: return "end of file";
    case FtpError::UnknownCommand: return "not supported by the vehicle";
    case FtpError::FileExists: return "the file exists";
    case FtpError::FileProtected: return "the file is protected";
    case FtpError::FileNotFound: return "no such file or folder";
    }
    return "the vehicle reports error code " + std::to_string(static_cast<unsigned>(error));
}

FtpListing parseListing(ByteView data)
{
    FtpListing out;
    std::string_view rest = asText(data);
    while (!rest.empty()) {
        const std::size_t end = rest.find('\0');
        const std::string_view text = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (text.empty())
            continue;
        ++out.count;
        if (auto entry = entryIn(text))
            out.entries.push_back(std::move(*entry));
    }
    return out;
}

std::uint32_t ftpChecksum(ByteView bytes, std::uint32_t crc)
{
    for (const std::uint8_t byte : bytes)
        crc = kCrcTable[(crc ^ byte) & 0xFF] ^ (crc >> 8);
    return crc;
}

} // namespace skyseal::vehicle
