#include "core/link/link_error.h"

#include <cerrno>
#include <system_error>

namespace skyseal::link {

const char *name(LinkErrorCode code)
{
    switch (code) {
    case LinkErrorCode::None: return "none";
    case LinkErrorCode::PortInUse: return "port-in-use";
    case LinkErrorCode::AddressUnavailable: return "address-unavailable";
    case LinkErrorCode::HostUnknown: return "host-unknown";
    case LinkErrorCode::Refused: return "refused";
    case LinkErrorCode::Unreachable: return "unreachable";
    case LinkErrorCode::TimedOut: return "timed-out";
    case LinkErrorCode::PeerClosed: return "peer-closed";
    case LinkErrorCode::PermissionDenied: return "permission-denied";
    case LinkErrorCode::DeviceMissing: return "device-missing";
    case LinkErrorCode::DeviceBusy: return "device-busy";
    case LinkErrorCode::FileUnreadable: return "file-unreadable";
    case LinkErrorCode::EndOfFile: return "end-of-file";
    case LinkErrorCode::NotSupported: return "not-supported";
    case LinkErrorCode::System: return "system";
    }
    return "system";
}

static std::string textOf(LinkErrorCode code, const std::string &subject)
{
    switch (code) {
    case LinkErrorCode::None: return "no error";
    case LinkErrorCode::PortInUse: return "port " + subject + " is in use by another program";
    case LinkErrorCode::AddressUnavailable: return subject + " is not an address of this machine";
    case LinkErrorCode::HostUnknown: return "the host name \"" + subject + "\" is not known";
    case LinkErrorCode::Refused: return subject + " refuses the connection (nothing listens there)";
    case LinkErrorCode::Unreachable: return subject + " cannot be reached";
    case LinkErrorCode::TimedOut: return subject + " does not answer";
    case LinkErrorCode::PeerClosed: return subject + " closed the connection";
    case LinkErrorCode::PermissionDenied: return "no permission to open " + subject;
    case LinkErrorCode::DeviceMissing: return "there is no device " + subject;
    case LinkErrorCode::DeviceBusy: return "the device " + subject + " is in use by another program";
    case LinkErrorCode::FileUnreadable: return "cannot read " + subject;
    case LinkErrorCode::EndOfFile: return "end of " + subject;
    case LinkErrorCode::NotSupported: return subject + " is not supported here";
    case LinkErrorCode::System: break;
    }
    return subject + " failed";
}

std::string LinkError::sentence() const
{
    std::string out = textOf(code, subject);
    if (!detail.empty())
        out += ": " + detail;
    return out;
}

static LinkErrorCode codeOf(int number)
{
    switch (number) {
    case EADDRINUSE: return LinkErrorCode::PortInUse;
    case EADDRNOTAVAIL: return LinkErrorCode::AddressUnavailable;
    case ECONNREFUSED: return LinkErrorCode::Refused;
    case EHOSTUNREACH:
    case ENETUNREACH: return LinkErrorCode::Unreachable;
    case ETIMEDOUT: return LinkErrorCode::TimedOut;
    case ECONNRESET:
    case EPIPE: return LinkErrorCode::PeerClosed;
    case EACCES:
    case EPERM: return LinkErrorCode::PermissionDenied;
    case ENOENT:
    case ENODEV: return LinkErrorCode::DeviceMissing;
    case EBUSY: return LinkErrorCode::DeviceBusy;
    case EAFNOSUPPORT: return LinkErrorCode::NotSupported;
    default: return LinkErrorCode::System;
    }
}

LinkError systemError(int number, std::string subject)
{
    const LinkErrorCode code = codeOf(number);
    const bool ownText = code != LinkErrorCode::System && code != LinkErrorCode::NotSupported;
    return {code, std::move(subject), ownText ? std::string() : std::generic_category().message(number)};
}

} // namespace skyseal::link
