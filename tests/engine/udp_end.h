// Another ground station, or a vehicle, on UDP: sends single messages to one port and keeps what it receives.
#pragma once

#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

#include <QtNetwork/QUdpSocket>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace skyseal::test {

class UdpEnd
{
public:
    explicit UdpEnd(quint16 target, std::uint8_t componentId = 190) : m_target(target), m_componentId(componentId)
    {
        if (!m_socket.bind(QHostAddress::LocalHost))
            qFatal("no port");
        QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { receive(); });
    }

    template<typename Message> void send(const Message &message, std::uint8_t systemId = 255)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = mavlink::FrameWriter(systemId, m_componentId).write(message, buffer);
        m_socket.writeDatagram(reinterpret_cast<const char *>(frame.data()), static_cast<qint64>(frame.size()),
                               QHostAddress::LocalHost, m_target);
    }

    quint16 port() const { return m_socket.localPort(); }
    bool received(const QByteArray &datagram) const { return std::ranges::find(datagrams, datagram) != datagrams.end(); }
    /// All messages of a kind, in the order of their arrival.
    template<typename Message> std::vector<Message> all() const
    {
        std::vector<Message> out;
        for (const QByteArray &datagram : datagrams) {
            mavlink::scanFrames(
                ByteView(reinterpret_cast<const std::uint8_t *>(datagram.constData()), std::size_t(datagram.size())),
                mavlink::Dialect::builtin(), [&out](const mavlink::ScanItem &item) {
                    if (item.frame && item.frame->messageId() == Message::kId)
                        out.push_back(Message::decode(item.frame->payload()));
                });
        }
        return out;
    }
    /// The newest message of a kind that satisfies a condition.
    template<typename Message, typename Condition> std::optional<Message> newest(Condition condition) const
    {
        std::optional<Message> out;
        for (const Message &message : all<Message>()) {
            if (condition(message))
                out = message;
        }
        return out;
    }

    template<typename Message> std::optional<Message> newest() const
    {
        return newest<Message>([](const Message &) { return true; });
    }
    /// The answer to a command.
    std::optional<mavlink::CommandAck> answerTo(int command) const
    {
        return newest<mavlink::CommandAck>([command](const mavlink::CommandAck &ack) { return ack.command == command; });
    }
    /// The answer to a command of this system.
    std::optional<mavlink::CommandAck> answerTo(int command, std::uint8_t systemId) const
    {
        return newest<mavlink::CommandAck>([command, systemId](const mavlink::CommandAck &ack) {
            return ack.command == command && ack.target_system == systemId;
        });
    }

    std::vector<QByteArray> datagrams;

private:
    void receive()
    {
        while (m_socket.hasPendingDatagrams()) {
            QByteArray datagram(static_cast<qsizetype>(m_socket.pendingDatagramSize()), Qt::Uninitialized);
            m_socket.readDatagram(datagram.data(), datagram.size());
            datagrams.push_back(datagram);
        }
    }

    QUdpSocket m_socket;
    const quint16 m_target;
    const std::uint8_t m_componentId;
};

} // namespace skyseal::test
