// An attacker on the path between agent and station: forwards and records datagrams, may drop or change them, and sends
// datagrams of its own to either side from the address of the other.
#pragma once

#include <QtNetwork/QNetworkDatagram>
#include <QtNetwork/QUdpSocket>

#include <functional>
#include <vector>

namespace skyseal::test {

class UdpAttacker
{
public:
    struct Seen
    {
        bool toGround = false;
        QByteArray bytes;
    };

    explicit UdpAttacker(quint16 groundPort) : m_groundPort(groundPort)
    {
        m_near.bind(QHostAddress::LocalHost, 0);
        m_far.bind(QHostAddress::LocalHost, 0);
        QObject::connect(&m_near, &QUdpSocket::readyRead, &m_near, [this] { take(m_near, true); });
        QObject::connect(&m_far, &QUdpSocket::readyRead, &m_far, [this] { take(m_far, false); });
    }

    /// The port that the agent takes for the station.
    quint16 port() const { return m_near.localPort(); }
    void toGround(const QByteArray &bytes) { m_far.writeDatagram(bytes, QHostAddress::LocalHost, m_groundPort); }
    void toAgent(const QByteArray &bytes)
    {
        if (m_agentPort != 0)
            m_near.writeDatagram(bytes, QHostAddress::LocalHost, m_agentPort);
    }

    std::vector<Seen> seen;
    /// Called for each datagram; return false to drop it.
    std::function<bool(const Seen &)> passes;

private:
    void take(QUdpSocket &socket, bool toGroundSide)
    {
        while (socket.hasPendingDatagrams()) {
            const QNetworkDatagram datagram = socket.receiveDatagram();
            if (toGroundSide)
                m_agentPort = static_cast<quint16>(datagram.senderPort());
            seen.push_back({toGroundSide, datagram.data()});
            if (passes && !passes(seen.back()))
                continue;
            toGroundSide ? toGround(datagram.data()) : toAgent(datagram.data());
        }
    }

    QUdpSocket m_near, m_far;
    quint16 m_groundPort;
    quint16 m_agentPort = 0;
};

} // namespace skyseal::test
