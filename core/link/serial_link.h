// A serial device: telemetry radio or autopilot on USB. 8N1 without flow control, as MAVLink devices speak. A device that
// is unplugged is waited for and opened again. Only built where Qt SerialPort is present.
#pragma once

#include "core/link/backoff.h"
#include "core/link/stream_peer.h"

#include <QtCore/QTimer>
#include <QtSerialPort/QSerialPort>

#include <memory>

namespace skyseal::link {

class SerialLink final : public Link
{
    Q_OBJECT

public:
    SerialLink(LinkUrl url, LinkId id, LinkListener &listener, LinkOptions options);
    ~SerialLink() override;

    void open() override;
    void close() override;
    /// A line has one other end: the address says nothing.
    void send(const Address &to, ByteView block) override;
    void flush() override;

private:
    void openNow();
    void failed(QSerialPort::SerialPortError error);
    void dropPeer();

    QSerialPort m_port;
    QTimer m_retryTimer;
    Backoff m_backoff;
    std::unique_ptr<StreamPeer> m_peer; ///< while open
};

} // namespace skyseal::link
