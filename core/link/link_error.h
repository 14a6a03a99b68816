// Reason why a link is down, as a value: a code for programs, a sentence for people.
#pragma once

#include "core/base/reason.h"

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
    NotSupported, ///< not in this build, or not on this system
    System,       ///< any other error; `detail` has the system's message
};

/// Keyword for scripts, e.g. "port-in-use".
const char *name(LinkErrorCode code);

struct LinkError
{
    LinkErrorCode code = LinkErrorCode::None;
    std::string subject; ///< the address, host, device or file
    Reason detail;       ///< program that holds the port, or the system's message; may be empty

    bool operator==(const LinkError &) const = default;
    /// "port 0.0.0.0:14550 is in use by another program".
    Reason reason() const;
    /// The reason in English.
    std::string sentence() const { return reason().text(); }
};

/// Converts an errno of a socket or device call.
LinkError systemError(int number, std::string subject);

} // namespace skyseal::link
