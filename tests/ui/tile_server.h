// A tile server on loopback: answers GET by a function, and notes who asked for what, on how many connections.
#pragma once

#include <QtCore/QBuffer>
#include <QtCore/QSet>
#include <QtGui/QImage>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>

#include <functional>

namespace skyseal::ui {

/// A tile of one colour.
inline QByteArray tileBytes(const QColor &color = Qt::red, const char *format = "png", QSize size = {256, 256})
{
    QImage image(size, QImage::Format_RGB32);
    image.fill(color);
    QByteArray out;
    QBuffer buffer(&out);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, format);
    return out;
}

class TileServer : public QTcpServer
{
public:
    struct Answer
    {
        int status = 200;
        QByteArray body = {};
        QByteArray headers = {}; ///< further lines, each with its end
    };

    TileServer()
    {
        listen(QHostAddress::LocalHost);
        connect(this, &QTcpServer::newConnection, this, [this] {
            while (QTcpSocket *socket = nextPendingConnection()) {
                mostOpen = std::max(mostOpen, ++m_open);
                connect(socket, &QTcpSocket::readyRead, this, [this, socket] { read(*socket); });
                connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
                    --m_open;
                    socket->deleteLater();
                });
            }
        });
    }

    QString address() const { return QStringLiteral("http://127.0.0.1:%1/{z}/{x}/{y}.png").arg(serverPort()); }

    std::function<Answer(const QString &path)> answer = [](const QString &) { return Answer{200, tileBytes()}; };
    QStringList paths, agents; ///< of all requests
    int mostOpen = 0;          ///< connections at the same time

private:
    void read(QTcpSocket &socket)
    {
        QByteArray &text = m_received[&socket];
        text += socket.readAll();
        for (qsizetype end; (end = text.indexOf("\r\n\r\n")) >= 0;) {
            const QList<QByteArray> lines = text.left(end).split('\n');
            text.remove(0, end + 4);
            paths << QString::fromLatin1(lines.first().split(' ').value(1));
            for (const QByteArray &line : lines)
                if (line.toLower().startsWith("user-agent:"))
                    agents << QString::fromLatin1(line.mid(11).trimmed());
            const Answer out = answer(paths.last());
            socket.write("HTTP/1.1 " + QByteArray::number(out.status) + " x\r\nContent-Length: "
                         + QByteArray::number(out.body.size()) + "\r\n" + out.headers + "\r\n" + out.body);
        }
    }

    int m_open = 0;
    QHash<QTcpSocket *, QByteArray> m_received;
};

} // namespace skyseal::ui
