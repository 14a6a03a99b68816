// Local sockets between programs of one user: an agent and `skyseal-air --pair`, a gateway and the commands that ask it.
#pragma once

#include "core/base/result.h"

#include <QtCore/QString>

#include <string>

QT_BEGIN_NAMESPACE
class QLocalServer;
class QLocalSocket;
QT_END_NAMESPACE

namespace skyseal::app {

/// Listens at an absolute path, open to the same user only. The socket of a program that was killed is replaced; where a
/// program listens already, or a file of another kind is, the error says so.
Result<void, InputError> listenLocally(QLocalServer &server, const QString &path);

/// True if the program that listens at the other end of a connected socket runs as this user, as root, or as the owner of
/// `file`: anyone may listen at a path where they can write. Linux; elsewhere true, and the rights of the folder decide alone.
bool isListenerTrusted(const QLocalSocket &socket, const std::string &file);

} // namespace skyseal::app
