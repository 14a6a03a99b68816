// A subscriber of an MQTT broker (MQTT 3.1.1): keeps every message of the topics it asks for.
#pragma once

#include "tests/support/eventually.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtNetwork/QSslConfiguration>
#include <QtNetwork/QSslSocket>

#include <vector>

namespace skyseal::test {

class MqttReader
{
public:
    struct Message
    {
        QByteArray topic, payload;
        bool retained = false; ///< of before the subscription

        QJsonObject json() const { return QJsonDocument::fromJson(payload).object(); }
    };

    /// Subscribes to `filter` with QoS 1 as soon as the broker accepts the connection.
    MqttReader(quint16 port, const QSslConfiguration &tls, const QByteArray &filter = "#") : m_filter(filter)
    {
        QObject::connect(&m_socket, &QSslSocket::encrypted, &m_socket, [this] {
            const QByteArray id = "reader" + QByteArray::number(reinterpret_cast<quintptr>(this));
            send('\x10', text("MQTT") + QByteArray("\x04\x02\x00\x00", 4) + text(id)); // clean session, may be silent
        });
        QObject::connect(&m_socket, &QSslSocket::readyRead, &m_socket, [this] { read(); });
        m_socket.setSslConfiguration(tls);
        m_socket.connectToHostEncrypted(QStringLiteral("127.0.0.1"), port);
    }

    bool waitUntilSubscribed()
    {
        return eventually([this] { return m_subscribed; });
    }
    /// Waits for a message of this topic that satisfies `predicate`, among those not returned before. Empty topic: none came.
    template<typename Predicate> Message waitFor(const QByteArray &topic, Predicate predicate)
    {
        Message out;
        const bool found = eventually([&] {
            for (std::size_t &next = m_next[topic]; next < messages.size(); ++next) {
                const Message &message = messages[next];
                if (message.topic != topic || !predicate(message))
                    continue;
                ++next;
                out = message;
                return true;
            }
            return false;
        });
        return found ? out : Message();
    }
    Message waitFor(const QByteArray &topic)
    {
        return waitFor(topic, [](const Message &) { return true; });
    }
    /// Called for each message, which is not kept then.
    void setTaker(std::function<void(const Message &)> take) { m_take = std::move(take); }

    std::vector<Message> messages;

private:
    void send(char first, const QByteArray &body) { m_socket.write(QByteArray(1, first) + char(body.size()) + body); }
    static QByteArray text(const QByteArray &content) { return QByteArray(1, '\0') + char(content.size()) + content; }

    void read()
    {
        m_received += m_socket.readAll();
        qsizetype at = 0;
        while (const qsizetype size = packetAt(at))
            at += size;
        m_received.remove(0, at);
    }

    /// Returns the size of the packet there, 0 if it is not whole.
    qsizetype packetAt(qsizetype at)
    {
        qsizetype length = 0, begin = at + 1;
        for (int shift = 0;; shift += 7) {
            if (begin >= m_received.size())
                return 0;
            const auto byte = static_cast<uchar>(m_received[begin++]);
            length |= qsizetype(byte & 0x7f) << shift;
            if (!(byte & 0x80))
                break;
        }
        if (m_received.size() < begin + length)
            return 0;
        take(static_cast<uchar>(m_received[at]), m_received.mid(begin, length));
        return begin + length - at;
    }

    void take(int first, const QByteArray &body)
    {
        if (first == 0x20 && body == QByteArray("\0\0", 2)) {
            send('\x82', QByteArray("\0\1", 2) + text(m_filter) + '\1');
        } else if (first == 0x90) {
            m_subscribed = !body.endsWith('\x80');
        } else if ((first & 0xf0) == 0x30) {
            const qsizetype topicEnd = 2 + (static_cast<uchar>(body[0]) << 8 | static_cast<uchar>(body[1]));
            const bool confirmed = first & 0x02;
            Message message{body.mid(2, topicEnd - 2), body.mid(topicEnd + (confirmed ? 2 : 0)), (first & 1) != 0};
            if (confirmed)
                send('\x40', body.mid(topicEnd, 2));
            if (m_take)
                m_take(message);
            else
                messages.push_back(std::move(message));
        }
    }

    QSslSocket m_socket;
    const QByteArray m_filter;
    QByteArray m_received;
    bool m_subscribed = false;
    std::map<QByteArray, std::size_t> m_next;
    std::function<void(const Message &)> m_take;
};

} // namespace skyseal::test
