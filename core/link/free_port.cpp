#include "core/link/free_port.h"

#include <QtCore/QRandomGenerator>
#include <QtNetwork/QUdpSocket>

#include <deque>

namespace skyseal::link {

namespace {
/// Below the ports that Linux gives to sockets that ask for any (net.ipv4.ip_local_port_range).
constexpr std::uint16_t kFirst = 26'000, kEnd = 32'000;
constexpr int kMostTried = 1000; ///< for one port
} // namespace

std::vector<std::uint16_t> freeUdpPorts(std::size_t count)
{
    std::deque<QUdpSocket> bound; // all of them until the last one is found, so that they differ
    std::vector<std::uint16_t> ports;
    for (std::size_t i = 0; i < count; ++i) {
        QUdpSocket &probe = bound.emplace_back();
        bool found = false;
        for (int tried = 0; !found && tried < kMostTried; ++tried)
            found = probe.bind(QHostAddress::LocalHost,
                               static_cast<quint16>(QRandomGenerator::global()->bounded(kFirst, kEnd)));
        if (!found)
            probe.bind(QHostAddress::LocalHost, 0);
        ports.push_back(probe.localPort());
    }
    return ports;
}

} // namespace skyseal::link
