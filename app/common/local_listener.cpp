#include "app/common/local_listener.h"

#include <QtCore/QFileInfo>
#include <QtNetwork/QLocalServer>
#include <QtNetwork/QLocalSocket>

#include <cerrno>
#include <cstring>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace skyseal::app {

Result<void, InputError> listenLocally(QLocalServer &server, const QString &path)
{
    constexpr int kPatienceMs = 1000;
    const auto fail = [&path](std::string problem) {
        return tl::unexpected(InputError{std::move(problem), path.toStdString()});
    };
    const QByteArray name = path.toLocal8Bit();
    if (static_cast<std::size_t>(name.size()) >= sizeof(sockaddr_un::sun_path))
        return fail("is too long for a socket: " + std::to_string(sizeof(sockaddr_un::sun_path) - 1)
                    + " bytes are the most; choose a shorter folder");
    server.setSocketOptions(QLocalServer::UserAccessOption);
    struct stat status
    {};
    if (::lstat(name.constData(), &status) == 0) {
        if (!S_ISSOCK(status.st_mode))
            return fail("exists and is not a socket");
        QLocalSocket probe;
        probe.connectToServer(path);
        if (probe.waitForConnected(kPatienceMs))
            return fail("another program listens there");
        if (probe.error() != QLocalSocket::ConnectionRefusedError)
            return fail("another program may listen there: it does not answer");
        QLocalServer::removeServer(path); // of a program that was killed
    }
    if (::access(QFileInfo(path).absolutePath().toLocal8Bit().constData(), W_OK | X_OK) != 0)
        return fail(std::string("cannot be created: ") + std::strerror(errno));
    if (!server.listen(path))
        return fail("cannot be created: " + server.errorString().toStdString());
    return {};
}

bool isListenerTrusted(const QLocalSocket &socket, const std::string &file)
{
#ifdef SO_PEERCRED
    ucred listener{};
    socklen_t length = sizeof listener;
    if (::getsockopt(static_cast<int>(socket.socketDescriptor()), SOL_SOCKET, SO_PEERCRED, &listener, &length) != 0)
        return false;
    struct stat status
    {};
    return listener.uid == ::geteuid() || listener.uid == 0
        || (::stat(file.c_str(), &status) == 0 && listener.uid == status.st_uid);
#else
    static_cast<void>(socket);
    static_cast<void>(file);
    return true;
#endif
}

} // namespace skyseal::app
