// A program on UDP behind a gateway: asks the vehicle for its thousand frames a second, in clear and with the right to
// command, and remembers what arrives.
#pragma once

#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/support/bare_socket.h"
#include "tests/support/frame_trail.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include <deque>
#include <memory>

namespace skyseal::test {

class SoakClient
{
public:
    static constexpr int kFramesASecond = 1000;

    explicit SoakClient(quint16 gateway) : m_gateway(gateway)
    {
        m_clock.start();
        QObject::connect(&m_second, &QTimer::timeout, &m_second, [this] { everySecond(); });
        m_second.start(1000);
    }

    /// From now on with another address.
    void move()
    {
        m_socket = std::make_unique<BareSocket>();
        send(heartbeat());
    }
    void receive()
    {
        while (const std::size_t count = m_socket->receive()) {
            for (std::size_t i = 0; i < count; ++i)
                received.take(m_socket->received(i));
        }
        const qint64 now = m_clock.elapsed();
        m_history.emplace_back(now, received.frames());
        while (m_history.size() > 2 && m_history[1].first <= now - 1000)
            m_history.pop_front();
    }
    /// Frames of the vehicle a second, over the last one; 0 until there was one.
    double rate() const
    {
        if (m_history.size() < 2 || m_history.back().first - m_history.front().first < 1000)
            return 0;
        const auto frames = double(m_history.back().second - m_history.front().second);
        return frames * 1000 / double(m_history.back().first - m_history.front().first);
    }
    /// rate() is of the time from now on.
    void forgetRate() { m_history.clear(); }

    FrameTrail received;

private:
    static mavlink::Heartbeat heartbeat()
    {
        mavlink::Heartbeat out;
        out.type = mavlink::MAV_TYPE_GCS;
        out.autopilot = mavlink::MAV_AUTOPILOT_INVALID;
        return out;
    }

    void everySecond()
    {
        receive();
        send(heartbeat()); // a silent client is forgotten
        if (rate() > 0.9 * kFramesASecond)
            return;
        constexpr std::array<std::uint32_t, 5> kMessages{mavlink::Attitude::kId, mavlink::GlobalPositionInt::kId,
                                                         mavlink::VfrHud::kId, mavlink::LocalPositionNed::kId,
                                                         mavlink::ServoOutputRaw::kId};
        for (const std::uint32_t message : kMessages) {
            mavlink::CommandLong interval;
            interval.target_system = interval.target_component = 1;
            interval.command = mavlink::MAV_CMD_SET_MESSAGE_INTERVAL;
            interval.param1 = float(message);
            interval.param2 = 1e6f * kMessages.size() / kFramesASecond;
            send(interval);
        }
    }

    template<typename Message> void send(const Message &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = m_writer.write(message, buffer);
        m_socket->send(m_gateway, {&frame, 1});
    }

    const quint16 m_gateway;
    std::unique_ptr<BareSocket> m_socket = std::make_unique<BareSocket>();
    mavlink::FrameWriter m_writer{250, 190};
    QElapsedTimer m_clock;
    QTimer m_second;
    std::deque<std::pair<qint64, std::uint64_t>> m_history; ///< time, ms, and frames until then
};

} // namespace skyseal::test
