// Converts socket errors of Qt to LinkError.
#pragma once

#include "core/link/link_error.h"

#include <QtNetwork/QAbstractSocket>

namespace skyseal::link {

LinkError socketError(QAbstractSocket::SocketError error, const QString &message, std::string subject);

inline LinkError socketError(const QAbstractSocket &socket, std::string subject)
{
    return socketError(socket.error(), socket.errorString(), std::move(subject));
}

} // namespace skyseal::link
