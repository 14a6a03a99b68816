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

static Sentence sentenceFor(LinkErrorCode code)
{
    switch (code) {
    case LinkErrorCode::None: return sentence("Reason", "no error");
    case LinkErrorCode::PortInUse: return sentence("Reason", "port %1 is in use by another program");
    case LinkErrorCode::AddressUnavailable: return sentence("Reason", "%1 is not an address of this machine");
    case LinkErrorCode::HostUnknown: return sentence("Reason", "the host name \"%1\" is not known");
    case LinkErrorCode::Refused: return sentence("Reason", "%1 refuses the connection (nothing listens there)");
    case LinkErrorCode::Unreachable: return sentence("Reason", "%1 cannot be reached");
    case LinkErrorCode::TimedOut: return sentence("Reason", "%1 does not answer");
    case LinkErrorCode::PeerClosed: return sentence("Reason", "%1 closed the connection");
    case LinkErrorCode::PermissionDenied: return sentence("Reason", "no permission to open %1");
    case LinkErrorCode::DeviceMissing: return sentence("Reason", "there is no device %1");
    case LinkErrorCode::DeviceBusy: return sentence("Reason", "the device %1 is in use by another program");
    case LinkErrorCode::FileUnreadable: return sentence("Reason", "cannot read %1");
    case LinkErrorCode::EndOfFile: return sentence("Reason", "end of %1");
    case LinkErrorCode::NotSupported: return sentence("Reason", "%1 is not supported here");
    case LinkErrorCode::System: break;
    }
    return sentence("Reason", "%1 failed");
}

Reason LinkError::reason() const
{
    const Reason plain = sentenceFor(code)(subject);
    return detail.empty() ? plain : skyseal::sentence("Reason", "%1: %2")(plain, detail);
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
    return {code, std::move(subject), ownText ? Reason() : Reason(std::generic_category().message(number))};
}

} // namespace skyseal::link
