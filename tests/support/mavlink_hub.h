// A MAVLink router of UDP ends that routes like mavlink-router: it learns the systems and components behind each end from the
// frames received there, and forwards a frame to the ends of its target, or to all others if it is a broadcast. Frames for an
// unknown target are dropped. Runs in the test's event loop.
#pragma once

#include "core/mavlink/dialect.h"
#include "core/mavlink/frame_scanner.h"

#include <QtCore/QObject>
#include <QtNetwork/QUdpSocket>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <map>
#include <set>

namespace skyseal::test {

class MavlinkHub
{
public:
    struct End
    {
        QUdpSocket socket;
        quint16 remote = 0; ///< 0: unknown until a frame arrives there
        std::set<std::pair<int, int>> heard;
    };

    explicit MavlinkHub(std::size_t ends = 2)
    {
        for (std::size_t i = 0; i < ends; ++i) {
            End &end = m_ends.emplace_back();
            end.socket.bind(QHostAddress::LocalHost, 0);
            QObject::connect(&end.socket, &QUdpSocket::readyRead, &end.socket, [this, &end] { take(end); });
        }
    }

    quint16 port(std::size_t end) const { return m_ends[end].socket.localPort(); }
    /// Gives an end a fixed remote port; otherwise it learns the port from the first frame.
    void setRemote(std::size_t end, quint16 port) { m_ends[end].remote = port; }

    std::map<std::uint32_t, int> passed; ///< by message id
    std::map<std::uint32_t, int> unrouted;
    std::size_t longest = 0; ///< frame
    std::uint64_t bytes = 0;
    int notMavlink = 0;
    /// Called for each frame; return false to drop it.
    std::function<bool(const mavlink::Frame &)> filter;

private:
    void take(End &from)
    {
        while (from.socket.hasPendingDatagrams()) {
            std::array<std::uint8_t, 2048> buffer;
            quint16 sender = 0;
            QHostAddress address;
            auto *const place = reinterpret_cast<char *>(buffer.data());
            const qint64 size = from.socket.readDatagram(place, buffer.size(), &address, &sender);
            if (size <= 0)
                continue;
            from.remote = sender;
            const ByteView datagram(buffer.data(), static_cast<std::size_t>(size));
            mavlink::FrameScanner scanner(datagram, mavlink::Dialect::builtin());
            while (const auto item = scanner.next()) {
                if (item->frame)
                    route(from, *item->frame);
                else
                    ++notMavlink;
            }
        }
    }

    void route(End &from, const mavlink::Frame &frame)
    {
        from.heard.insert({frame.systemId(), frame.componentId()});
        if (filter && !filter(frame))
            return;
        bool went = false;
        for (End &to : m_ends) {
            if (to.heard.contains({frame.systemId(), frame.componentId()}) || to.remote == 0 || !accepts(to, frame))
                continue;
            to.socket.writeDatagram(reinterpret_cast<const char *>(frame.bytes().data()), qint64(frame.bytes().size()),
                                    QHostAddress::LocalHost, to.remote);
            went = true;
        }
        ++(went ? passed : unrouted)[frame.messageId()];
        longest = std::max(longest, frame.bytes().size());
        bytes += frame.bytes().size();
    }

    static bool accepts(const End &to, const mavlink::Frame &frame)
    {
        const int system = frame.targetSystem(), component = frame.targetComponent();
        if (system == 0)
            return true;
        if (component != 0)
            return to.heard.contains({system, component});
        return std::any_of(to.heard.begin(), to.heard.end(), [system](const auto &node) { return node.first == system; });
    }

    std::deque<End> m_ends; // stable addresses, for the connections
};

} // namespace skyseal::test
