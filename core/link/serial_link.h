// Link over a serial device, such as a telemetry radio or an autopilot on USB: 8N1 without flow control. Opens the device
// again after it was unplugged. Built only with Qt SerialPort.
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
    /// Ignores the address: a serial line has one remote end.
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
