// Parses one part of a directory listing of MAVLink FTP.
// https://mavlink.io/en/services/ftp.html
#pragma once

#include "core/base/bytes.h"
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

} // namespace skyseal::vehicle
