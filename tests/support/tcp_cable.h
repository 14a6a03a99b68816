// A TCP relay to a port of 127.0.0.1 whose connections the test can cut. Runs in the test's event loop.
#pragma once

#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>

namespace skyseal::test {

class TcpCable
{
public:
    explicit TcpCable(quint16 to) : m_to(to)
    {
        m_server.listen(QHostAddress::LocalHost, 0);
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_server, [this] { join(); });
    }

    quint16 port() const { return m_server.serverPort(); }
    int joined = 0; ///< connections so far

    /// Both ends see the connection break.
    void cut()
    {
        for (QTcpSocket *socket : m_server.findChildren<QTcpSocket *>())
            socket->abort();
    }

private:
    void join()
    {
        while (QTcpSocket *caller = m_server.nextPendingConnection()) {
            auto *called = new QTcpSocket(&m_server);
            called->connectToHost(QHostAddress::LocalHost, m_to);
            pipe(caller, called);
            pipe(called, caller);
            ++joined;
        }
    }

    static void pipe(QTcpSocket *from, QTcpSocket *to)
    {
        QObject::connect(from, &QTcpSocket::readyRead, to, [from, to] { to->write(from->readAll()); });
        QObject::connect(from, &QTcpSocket::disconnected, to, [to] { to->abort(); });
    }

    QTcpServer m_server;
    quint16 m_to;
};

} // namespace skyseal::test
