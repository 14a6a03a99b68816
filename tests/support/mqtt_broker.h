// An MQTT broker for tests (MQTT 3.1.1, OASIS standard of 2014): accepts clients, keeps what they publish, and can be slow,
// silent, refuse, or close the connection.
#pragma once

#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>

#include <set>
#include <vector>

namespace skyseal::test {

class MqttBroker
{
public:
    /// Section 2.2.1.
    enum Packet : int { Connect = 1, Publish = 3, PubAck = 4, Subscribe = 8, PingReq = 12, Disconnect = 14 };

    struct Published
    {
        QByteArray topic, payload;
        int qos = 0;
        bool retained = false, again = false;
    };
    struct Client
    {
        QByteArray id, willTopic, willPayload, user, password;
        int willQos = 0, keepAlive = 0;
        bool willRetained = false;
    };

    MqttBroker()
    {
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_server, [this] { accept(); });
        listen();
    }

    quint16 port() const { return m_port; }
    QByteArray url() const { return "mqtt://127.0.0.1:" + QByteArray::number(m_port) + "/fleet"; }

    /// Ends the connection, if there is one, without a word.
    void drop()
    {
        if (m_socket)
            m_socket->abort();
    }
    void stopListening()
    {
        m_server.close();
        drop();
    }
    void listen()
    {
        if (!m_server.listen(QHostAddress::LocalHost, m_port))
            qFatal("no port");
        m_port = m_server.serverPort();
    }
    /// While false, the client's bytes stay in its buffers.
    void setReading(bool reading)
    {
        m_reading = reading;
        if (m_socket && reading)
            read();
    }
    void send(const QByteArray &packet) { m_socket->write(packet); }
    bool hasClient() const { return m_socket && m_socket->state() == QAbstractSocket::ConnectedState; }

    std::vector<QByteArray> payloadsOf(const QByteArray &topic) const
    {
        std::vector<QByteArray> out;
        for (const Published &message : published) {
            if (message.topic == topic)
                out.push_back(message.payload);
        }
        return out;
    }

    int code = 0;           ///< of the answer to CONNECT; not 0: refused
    bool confirming = true; ///< answers messages of QoS 1
    std::vector<Client> clients;
    std::vector<Published> published;
    std::set<int> packets; ///< types that were received

private:
    void accept()
    {
        drop();
        m_socket = m_server.nextPendingConnection();
        m_received.clear();
        m_socket->setReadBufferSize(kBuffer);
        QObject::connect(m_socket, &QTcpSocket::readyRead, m_socket, [this] { read(); });
        QObject::connect(m_socket, &QTcpSocket::disconnected, m_socket, [this, socket = m_socket] {
            socket->deleteLater();
            if (m_socket == socket)
                m_socket = nullptr;
        });
    }

    void read()
    {
        if (!m_reading || !m_socket)
            return;
        m_received += m_socket->readAll();
        while (takePacket())
            ;
    }

    /// Section 2.2.3: the length has seven bits in each byte.
    bool takePacket()
    {
        qsizetype length = 0, header = 1;
        for (int shift = 0;; shift += 7) {
            if (header >= m_received.size())
                return false;
            const auto byte = static_cast<uchar>(m_received[header++]);
            length |= qsizetype(byte & 0x7f) << shift;
            if (!(byte & 0x80))
                break;
        }
        if (m_received.size() < header + length)
            return false;
        const auto first = static_cast<uchar>(m_received[0]);
        const QByteArray body = m_received.mid(header, length);
        m_received.remove(0, header + length);
        take(first >> 4, first & 0x0f, body);
        return m_socket != nullptr;
    }

    void take(int type, int flags, const QByteArray &body)
    {
        packets.insert(type);
        qsizetype at = 0;
        if (type == Connect) {
            takeConnect(body);
        } else if (type == Publish) {
            Published message{text(body, at), {}, (flags >> 1) & 3, (flags & 1) != 0, (flags & 8) != 0};
            const QByteArray id = message.qos ? body.mid(at, 2) : QByteArray();
            message.payload = body.mid(at + id.size());
            published.push_back(message);
            if (message.qos == 1 && confirming)
                send(QByteArray("\x40\x02", 2) + id);
        } else if (type == PingReq) {
            send(QByteArray("\xd0\x00", 2));
        }
    }

    void takeConnect(const QByteArray &body)
    {
        qsizetype at = 0;
        text(body, at); // "MQTT"
        ++at;           // level
        const auto flags = static_cast<uchar>(body[at++]);
        Client client;
        client.keepAlive = static_cast<uchar>(body[at]) << 8 | static_cast<uchar>(body[at + 1]);
        at += 2;
        client.id = text(body, at);
        if (flags & 0x04) {
            client.willTopic = text(body, at);
            client.willPayload = text(body, at);
            client.willQos = (flags >> 3) & 3;
            client.willRetained = (flags & 0x20) != 0;
        }
        if (flags & 0x80)
            client.user = text(body, at);
        if (flags & 0x40)
            client.password = text(body, at);
        clients.push_back(client);
        const char answer[] = {0x20, 0x02, 0x00, static_cast<char>(code)};
        send(QByteArray(answer, 4));
        if (code != 0)
            m_socket->disconnectFromHost();
    }

    static QByteArray text(const QByteArray &body, qsizetype &at)
    {
        const qsizetype length = static_cast<uchar>(body[at]) << 8 | static_cast<uchar>(body[at + 1]);
        at += 2 + length;
        return body.mid(at - length, length);
    }

    static constexpr qint64 kBuffer = 4096;
    QTcpServer m_server;
    QTcpSocket *m_socket = nullptr; ///< of the newest client
    QByteArray m_received;
    quint16 m_port = 0;
    bool m_reading = true;
};

} // namespace skyseal::test
