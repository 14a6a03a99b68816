// Parses answers of MAVLink FTP: one part of a directory listing, and the reason of a refusal.
// https://mavlink.io/en/services/ftp.html
#pragma once

#include "core/mavlink/ftp_message.h"
#include "core/vehicle/remote_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace skyseal::vehicle {

/// One part of a directory.
struct FtpListing
{
    std::vector<RemoteFile> entries; ///< with printable names
    std::uint32_t count = 0;         ///< entries in the message, those that are skipped included
};
FtpListing parseListing(ByteView data);

/// For people: "no such file or folder", …; of MAV_FTP_ERR_FAILERRNO with the number that the vehicle sends.
std::string ftpErrorText(const mavlink::FtpMessage &refusal);

} // namespace skyseal::vehicle
