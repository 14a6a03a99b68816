// A vehicle on UDP with parameters on several components, in either version of MAVLink: one that knows version 1 alone drops
// everything else, as such autopilots do. Runs in the event loop of the test.
#pragma once

#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

#include <QtCore/QTimer>
#include <QtNetwork/QUdpSocket>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace skyseal::test {

class ScriptedVehicle
{
public:
    struct Value
    {
        std::uint8_t component = 1;
        std::string name;
        float raw = 0; ///< as on the wire
        std::uint8_t type = mavlink::MAV_PARAM_TYPE_REAL32;
    };

    /// Sends to this port of the loopback address. The components besides the autopilot are those of `values`.
    ScriptedVehicle(quint16 target, std::vector<Value> values, int version = 2,
                    std::uint8_t autopilot = mavlink::MAV_AUTOPILOT_PX4)
        : version(version), values(std::move(values)), m_target(target), m_autopilot(autopilot)
    {
        if (!m_socket.bind(QHostAddress::LocalHost))
            qFatal("no port");
        QObject::connect(&m_socket, &QUdpSocket::readyRead, &m_socket, [this] { receive(); });
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { sendHeartbeats(); });
        m_timer.start(200);
    }

    const Value *find(std::uint8_t component, std::string_view name) const
    {
        const auto found = std::ranges::find_if(
            values, [&](const Value &value) { return value.component == component && value.name == name; });
        return found == values.end() ? nullptr : &*found;
    }
    /// Frames of the station in this version.
    int heardIn(int wanted) const
    {
        const auto found = m_heard.find(wanted);
        return found == m_heard.end() ? 0 : found->second;
    }

    int version; ///< of its frames, and the highest that it understands
    std::vector<Value> values;
    int writes = 0; ///< PARAM_SETs

private:
    template<typename Message> void send(std::uint8_t component, const Message &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = mavlink::FrameWriter(1, component, version).write(message, buffer);
        m_socket.writeDatagram(reinterpret_cast<const char *>(frame.data()), static_cast<qint64>(frame.size()),
                               QHostAddress::LocalHost, m_target);
    }

    void sendHeartbeats()
    {
        send(1, mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = m_autopilot, .mavlink_version = 3});
        for (const Value &value : values) {
            if (value.component != 1)
                send(value.component,
                     mavlink::Heartbeat{
                         .type = mavlink::MAV_TYPE_GIMBAL, .autopilot = mavlink::MAV_AUTOPILOT_INVALID, .mavlink_version = 3});
        }
    }

    void sendValue(const Value &wanted)
    {
        mavlink::ParamValue out{.param_value = wanted.raw, .param_type = wanted.type};
        mavlink::setText(out.param_id, wanted.name);
        for (const Value &value : values) {
            if (value.component != wanted.component)
                continue;
            if (&value == &wanted)
                out.param_index = out.param_count;
            ++out.param_count;
        }
        send(wanted.component, out);
    }

    void receive()
    {
        while (m_socket.hasPendingDatagrams()) {
            QByteArray datagram(static_cast<qsizetype>(m_socket.pendingDatagramSize()), Qt::Uninitialized);
            m_socket.readDatagram(datagram.data(), datagram.size());
            mavlink::scanFrames(
                ByteView(reinterpret_cast<const std::uint8_t *>(datagram.constData()), std::size_t(datagram.size())),
                mavlink::Dialect::builtin(), [this](const mavlink::ScanItem &item) {
                    if (item.frame)
                        handle(*item.frame);
                });
        }
    }

    void handle(const mavlink::Frame &frame)
    {
        ++m_heard[frame.version()];
        if (frame.version() > version)
            return;
        const auto isFor = [&frame](const Value &value) {
            return frame.targetComponent() == 0 || frame.targetComponent() == value.component;
        };
        if (frame.messageId() == mavlink::ParamRequestList::kId) {
            for (const Value &value : values) {
                if (isFor(value))
                    sendValue(value);
            }
        } else if (frame.messageId() == mavlink::ParamRequestRead::kId) {
            const auto read = mavlink::ParamRequestRead::decode(frame.payload());
            for (const Value &value : values) {
                if (isFor(value) && value.name == mavlink::textOf(read.param_id))
                    sendValue(value);
            }
        } else if (frame.messageId() == mavlink::ParamSet::kId) {
            const auto write = mavlink::ParamSet::decode(frame.payload());
            ++writes;
            for (Value &value : values) {
                if (!isFor(value) || value.name != mavlink::textOf(write.param_id) || value.type != write.param_type)
                    continue;
                value.raw = write.param_value;
                sendValue(value);
            }
        }
    }

    QUdpSocket m_socket;
    QTimer m_timer;
    const quint16 m_target;
    const std::uint8_t m_autopilot;
    std::map<int, int> m_heard;
};

} // namespace skyseal::test
