#include "core/link/socket_error.h"

namespace skyseal::link {

static LinkErrorCode codeOf(QAbstractSocket::SocketError error)
{
    switch (error) {
    case QAbstractSocket::AddressInUseError: return LinkErrorCode::PortInUse;
    case QAbstractSocket::SocketAddressNotAvailableError: return LinkErrorCode::AddressUnavailable;
    case QAbstractSocket::HostNotFoundError: return LinkErrorCode::HostUnknown;
    case QAbstractSocket::ConnectionRefusedError: return LinkErrorCode::Refused;
    case QAbstractSocket::RemoteHostClosedError: return LinkErrorCode::PeerClosed;
    case QAbstractSocket::SocketAccessError: return LinkErrorCode::PermissionDenied;
    case QAbstractSocket::SocketTimeoutError: return LinkErrorCode::TimedOut;
    case QAbstractSocket::NetworkError: return LinkErrorCode::Unreachable;
    case QAbstractSocket::UnsupportedSocketOperationError: return LinkErrorCode::NotSupported;
    default: return LinkErrorCode::System;
    }
}

LinkError socketError(QAbstractSocket::SocketError error, const QString &message, std::string subject)
{
    const LinkErrorCode code = codeOf(error);
    const bool needsText = code == LinkErrorCode::System || code == LinkErrorCode::NotSupported
        || code == LinkErrorCode::Unreachable;
    return {code, std::move(subject), needsText ? Reason(message.toStdString()) : Reason()};
}

} // namespace skyseal::link
