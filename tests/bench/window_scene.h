// What the window of a benchmark shows: vehicles that fly in circles, and a server of map tiles, each on a thread of its
// own.
#pragma once

#include "core/mavlink/messages.h"
#include "tests/support/clear_frames.h"
#include "tests/ui/tile_server.h"

#include <QtCore/QRandomGenerator>
#include <QtCore/QThread>
#include <QtCore/QTimer>
#include <QtGui/QPainter>
#include <QtNetwork/QUdpSocket>

#include <atomic>
#include <cmath>
#include <memory>
#include <numbers>

namespace skyseal::test {

/// Owns an object of type T on a thread of its own.
template<typename T> class OnThread
{
public:
    template<typename... Arguments> explicit OnThread(const Arguments &...arguments)
    {
        m_thread.start();
        m_context.moveToThread(&m_thread);
        QMetaObject::invokeMethod(
            &m_context, [&] { m_object = std::make_unique<T>(arguments...); }, Qt::BlockingQueuedConnection);
    }
    ~OnThread()
    {
        QMetaObject::invokeMethod(
            &m_context, [this] { m_object.reset(); }, Qt::BlockingQueuedConnection);
        m_thread.quit();
        m_thread.wait();
    }
    T &operator*() { return *m_object; }
    T *operator->() { return m_object.get(); }

private:
    QThread m_thread;
    QObject m_context;
    std::unique_ptr<T> m_object;
};

/// Copters in clear MAVLink: attitude, position and speed ten times a second each, the rest once a second.
class CirclingFleet
{
public:
    static constexpr int kVehicles = 50, kHz = 10;

    explicit CirclingFleet(quint16 port, int vehicles = kVehicles) : m_port(port), m_vehicles(vehicles)
    {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { step(); });
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.start(1000 / (m_vehicles * kHz));
    }

private:
    /// One vehicle after the other.
    void step()
    {
        const int vehicle = m_step % m_vehicles, round = m_step / m_vehicles;
        ++m_step;
        const auto id = static_cast<std::uint8_t>(vehicle + 1);
        const double angle = 0.01 * round + vehicle, radius = 60 + 8 * vehicle; // metres
        constexpr double kDegree = 111319.5;
        mavlink::GlobalPositionInt position;
        position.lat = static_cast<std::int32_t>((47.3977 + radius * std::cos(angle) / kDegree) * 1e7);
        position.lon = static_cast<std::int32_t>((8.5456 + radius * std::sin(angle) / kDegree / 0.677) * 1e7);
        position.alt = 500'000 + vehicle * 1000;
        position.relative_alt = 12'000 + vehicle * 1000;
        position.hdg = static_cast<std::uint16_t>(std::fmod(angle * 180 / std::numbers::pi + 90, 360) * 100);
        mavlink::Attitude attitude;
        attitude.roll = static_cast<float>(0.1 * std::sin(angle * 5));
        attitude.yaw = static_cast<float>(std::remainder(angle + std::numbers::pi / 2, 2 * std::numbers::pi));
        mavlink::VfrHud speed;
        speed.groundspeed = static_cast<float>(0.1 * radius);
        speed.alt = static_cast<float>(position.alt) / 1000;
        QByteArray datagram = frameOf(position, id, 1) + frameOf(attitude, id, 1) + frameOf(speed, id, 1);
        if (round % kHz == 0) {
            mavlink::Heartbeat beat;
            beat.type = mavlink::MAV_TYPE_QUADROTOR;
            beat.autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
            beat.base_mode = 0x81; // armed
            beat.custom_mode = 5;  // LOITER
            beat.system_status = mavlink::MAV_STATE_ACTIVE;
            mavlink::SysStatus status;
            status.voltage_battery = 15'800;
            status.battery_remaining = 78;
            mavlink::GpsRawInt gps;
            gps.fix_type = 3;
            gps.satellites_visible = 12;
            datagram += frameOf(beat, id, 1) + frameOf(status, id, 1) + frameOf(gps, id, 1);
        }
        m_socket.writeDatagram(datagram, QHostAddress::LocalHost, m_port);
    }

    quint16 m_port;
    int m_vehicles;
    QUdpSocket m_socket;
    QTimer m_timer;
    int m_step = 0;
};

/// Tiles of the size that maps have: some 20 kB.
class MapServer
{
public:
    MapServer()
    {
        for (int i = 0; i < kPictures; ++i)
            m_pictures.push_back(picture(i));
        m_server.answer = [this](const QString &path) {
            ++m_served;
            return ui::TileServer::Answer{200, m_pictures[static_cast<std::size_t>(qHash(path) % kPictures)]};
        };
    }

    QString address() const { return m_server.address(); }
    int served() const { return m_served; }
    qsizetype bytesEach() const { return m_pictures.front().size(); }

private:
    static constexpr int kPictures = 16;

    static QByteArray picture(quint32 seed)
    {
        QRandomGenerator random(seed);
        QImage image(256, 256, QImage::Format_RGB32);
        image.fill(0xffe8e4d8);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        for (int i = 0; i < 60; ++i) {
            painter.setPen(QPen(QColor::fromHsv(random.bounded(360), 60, 200), 1 + random.bounded(5)));
            painter.drawLine(random.bounded(256), random.bounded(256), random.bounded(256), random.bounded(256));
        }
        painter.end();
        QByteArray out;
        QBuffer buffer(&out);
        buffer.open(QIODevice::WriteOnly);
        image.save(&buffer, "png");
        return out;
    }

    std::vector<QByteArray> m_pictures;
    std::atomic<int> m_served = 0;
    ui::TileServer m_server;
};

} // namespace skyseal::test
