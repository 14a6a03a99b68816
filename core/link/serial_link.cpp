#include "core/link/serial_link.h"

#include <QtCore/QFile>

namespace skyseal::link {

static constexpr qint64 kSerialReadBuffer = 64 << 10;

SerialLink::SerialLink(LinkUrl linkUrl, LinkId linkId, LinkListener &linkListener, LinkOptions linkOptions)
    : Link(std::move(linkUrl), linkId, linkListener, linkOptions), m_backoff(options().retryFirst, options().retryMax)
{
    m_port.setPortName(QString::fromStdString(url().path()));
    m_port.setBaudRate(static_cast<qint32>(url().baud()));
    m_port.setReadBufferSize(kSerialReadBuffer);
    m_retryTimer.setSingleShot(true);
    connect(&m_retryTimer, &QTimer::timeout, this, &SerialLink::openNow);
    connect(&m_port, &QSerialPort::errorOccurred, this, &SerialLink::failed);
    connect(&m_port, &QSerialPort::readyRead, this, [this] {
        if (m_peer)
            m_peer->receive(*this, listener(), m_counters);
    });
}

SerialLink::~SerialLink()
{
    m_port.disconnect(this);
}

void SerialLink::open()
{
    if (state() != LinkState::Closed && state() != LinkState::Failed)
        return;
    m_backoff.reset();
    setState(LinkState::Opening);
    openNow();
}

void SerialLink::openNow()
{
    // Failures are handled in failed(), through errorOccurred.
    if (!m_port.open(QIODevice::ReadWrite))
        return;
    m_backoff.reset();
    const Path path{id(), {}};
    m_peer = std::make_unique<StreamPeer>(m_port, path, options().streamQueueBytes);
    setState(LinkState::Connected);
    listener().linkPeerJoined(*this, path);
}

static LinkErrorCode codeOf(QSerialPort::SerialPortError error)
{
    switch (error) {
    case QSerialPort::DeviceNotFoundError: return LinkErrorCode::DeviceMissing;
    case QSerialPort::PermissionError: return LinkErrorCode::PermissionDenied;
    case QSerialPort::ResourceError: return LinkErrorCode::DeviceMissing;
    case QSerialPort::UnsupportedOperationError: return LinkErrorCode::NotSupported;
    default: return LinkErrorCode::System;
    }
}

void SerialLink::failed(QSerialPort::SerialPortError error)
{
    if (error == QSerialPort::NoError || state() == LinkState::Closed || m_retryTimer.isActive())
        return;
    LinkErrorCode code = codeOf(error);
    const std::string message = m_port.errorString().toStdString();
    // QSerialPort reports PermissionError both for a device in use and for missing permissions.
    if (code == LinkErrorCode::PermissionDenied && message.find("busy") != std::string::npos)
        code = LinkErrorCode::DeviceBusy;
    // The first sign of an unplugged device is a read error.
    if (code == LinkErrorCode::System && !QFile::exists(QString::fromStdString(url().path())))
        code = LinkErrorCode::DeviceMissing;
    LinkError reason{code, url().path(), {}};
    if (code == LinkErrorCode::System || code == LinkErrorCode::NotSupported)
        reason.detail = message;
    m_retryTimer.start(std::chrono::duration_cast<std::chrono::milliseconds>(m_backoff.next()));
    setState(LinkState::Waiting, std::move(reason));
    dropPeer();
    if (m_port.isOpen())
        m_port.close();
}

void SerialLink::dropPeer()
{
    if (!m_peer)
        return;
    const Path path = m_peer->path();
    m_peer.reset();
    listener().linkPeerLeft(*this, path);
}

void SerialLink::send(const Address &, ByteView block)
{
    if (m_peer)
        m_peer->send(block, m_counters);
    else
        ++m_counters.txDropped;
}

void SerialLink::flush()
{
    if (m_peer)
        m_peer->flush(m_counters);
}

void SerialLink::close()
{
    if (state() == LinkState::Closed)
        return;
    m_retryTimer.stop();
    flush();
    if (m_port.isOpen())
        m_port.flush();
    setState(LinkState::Closed);
    dropPeer();
    m_port.close();
}

} // namespace skyseal::link

#include "moc_serial_link.cpp"
