// An attacker at a MAVLink router that accepts frames with any system id.
#pragma once

#include "core/mavlink/messages.h"
#include "tests/support/clear_frames.h"
#include "tests/support/heartbeat.h"

#include <QtCore/QIODevice>
#include <QtCore/QTimer>

#include <array>
#include <functional>
#include <utility>

namespace skyseal::test {

/// Sends armed heartbeats as the vehicle, its agent and the station, each from a connection of its own, so that the router
/// forwards the frames for these to the attacker.
template<typename Socket> class RouterSpoofers
{
public:
    static constexpr std::array<std::pair<std::uint8_t, std::uint8_t>, 3> kNames{{{1, 1}, {1, 191}, {255, 190}}};

    /// `join` connects the socket of each name.
    explicit RouterSpoofers(const std::function<void(std::size_t, Socket &)> &join)
    {
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            join(i, m_sockets[i]);
            QObject::connect(&m_sockets[i], &QIODevice::readyRead, &m_sockets[i], [this, i] { look(m_sockets[i].readAll()); });
        }
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] {
            for (std::size_t i = 0; i < kNames.size(); ++i)
                m_sockets[i].write(clearHeartbeat(kNames[i].first, kNames[i].second, true));
        });
        m_timer.start(100);
    }

    int copied = 0;    ///< TUNNEL messages that the router forwarded to the attacker
    bool more = false; ///< anything else but HEARTBEAT
    std::function<void(const mavlink::Frame &)> onCopy;

private:
    void look(const QByteArray &bytes)
    {
        mavlink::FrameScanner scanner(viewOf(bytes), mavlink::Dialect::builtin());
        while (const auto item = scanner.next()) {
            if (!item->frame || item->frame->messageId() == mavlink::Heartbeat::kId)
                continue;
            if (item->frame->messageId() != mavlink::Tunnel::kId) {
                more = true;
                continue;
            }
            ++copied;
            if (onCopy)
                onCopy(*item->frame);
        }
    }

    std::array<Socket, kNames.size()> m_sockets;
    QTimer m_timer;
};

} // namespace skyseal::test
