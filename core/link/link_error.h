// Why a link is not carrying anything, as a value. Programs decide on the code; people read the sentence.
#pragma once

#include <cstdint>
#include <string>

namespace skyseal::link {

enum class LinkErrorCode : std::uint8_t {
    None,
    PortInUse,
    AddressUnavailable, ///< the local address is not one of this machine's
    HostUnknown,
    Refused,
    Unreachable,
    TimedOut,
    PeerClosed,
    PermissionDenied,
    DeviceMissing,
    DeviceBusy,
    FileUnreadable,
    EndOfFile,
    NotSupported, ///< built without, or not on this system
    System,       ///< anything else; `detail` has the system's own words
};

/// One word for scripts, e.g. "port-in-use".
const char *name(LinkErrorCode code);

struct LinkError
{
    LinkErrorCode code = LinkErrorCode::None;
    std::string subject; ///< what it happened to: an address, host, device or file
    std::string detail;  ///< what else is known (who holds the port, the system's message), may be empty

    bool operator==(const LinkError &) const = default;
    /// One plain English sentence without a full stop, e.g. "port 0.0.0.0:14550 is in use by another program".
    std::string sentence() const;
};

/// From an errno of the socket or device calls.
LinkError systemError(int number, std::string subject);

} // namespace skyseal::link
