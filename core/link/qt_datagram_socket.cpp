#include "core/link/qt_datagram_socket.h"

#include "core/link/address_text.h"
#include "core/link/socket_error.h"
#include "core/link/steady_now.h"

#include <QtCore/QVariant>
#include <QtNetwork/QNetworkProxy>

#if defined(__linux__)
#include "core/link/batch_socket.h"
#endif

namespace skyseal::link {

struct QtDatagramSocket::Buffers
{
    // One byte more than allowed: a datagram that fills the buffer is oversized.
    std::array<std::array<std::uint8_t, kMaxDatagram + 1>, kBatch> bytes;
    std::array<ReceivedBlock, kBatch> blocks;
};

QtDatagramSocket::QtDatagramSocket() : m_buffers(std::make_unique<Buffers>())
{
    m_socket.setProxy(QNetworkProxy::NoProxy); // see TcpLink
    connect(&m_socket, &QUdpSocket::readyRead, this, [this] { noteReadable(); });
}

QtDatagramSocket::~QtDatagramSocket() = default;

std::optional<LinkError> QtDatagramSocket::bind(const Address &local, int receiveBufferBytes)
{
    m_ipv6 = !isIpv4(local);
    const QHostAddress host = isAnyAddress(local) && m_ipv6 ? QHostAddress(QHostAddress::Any) : toQt(local);
    if (!m_socket.bind(host, local.port, QAbstractSocket::DontShareAddress))
        return socketError(m_socket, toText(local));
    m_socket.setSocketOption(QAbstractSocket::ReceiveBufferSizeSocketOption, receiveBufferBytes);
    return std::nullopt;
}

Address QtDatagramSocket::local() const
{
    return fromQt(m_socket.localAddress(), m_socket.localPort());
}

DatagramSocket::Batch QtDatagramSocket::receive(LinkId id, LinkCounters &counters, std::size_t most)
{
    std::size_t used = 0;
    std::size_t read = 0;
    const TimePoint now = steadyNow();
    for (; read < most && m_socket.hasPendingDatagrams(); ++read) {
        auto &bytes = m_buffers->bytes[used];
        QHostAddress host;
        quint16 port = 0;
        const qint64 length = m_socket.readDatagram(reinterpret_cast<char *>(bytes.data()), qint64(bytes.size()), &host, &port);
        if (length < 0) {
            ++counters.rxErrors;
            continue;
        }
        if (static_cast<std::size_t>(length) > kMaxDatagram) {
            ++counters.rxOversized;
            continue;
        }
        counters.rxBytes += static_cast<std::uint64_t>(length);
        m_buffers->blocks[used++] = {
            {id, fromQt(host, port)}, MutableByteView(bytes).first(static_cast<std::size_t>(length)), now};
    }
    counters.rxBlocks += used;
    return {std::span<const ReceivedBlock>(m_buffers->blocks.data(), used), read < most};
}

void QtDatagramSocket::send(const Address &to, ByteView datagram, LinkCounters &counters)
{
    if (datagram.size() > kMaxDatagram || (!m_ipv6 && !isIpv4(to))) {
        ++counters.txDropped;
        return;
    }
    const qint64 sent = m_socket.writeDatagram(reinterpret_cast<const char *>(datagram.data()), qint64(datagram.size()),
                                               toQt(to), to.port);
    if (sent >= 0) {
        ++counters.txBlocks;
        counters.txBytes += datagram.size();
    } else if (m_socket.error() == QAbstractSocket::TemporaryError) {
        ++counters.txDropped;
    } else {
        ++counters.txErrors;
    }
}

std::unique_ptr<DatagramSocket> makeDatagramSocket(const LinkOptions &options)
{
#if defined(__linux__)
    if (!options.portableUdp)
        return std::make_unique<BatchSocket>(options.segmentedUdp);
#endif
    static_cast<void>(options);
    return std::make_unique<QtDatagramSocket>();
}

} // namespace skyseal::link

#include "moc_qt_datagram_socket.cpp"
