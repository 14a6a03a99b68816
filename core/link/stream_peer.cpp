#include "core/link/stream_peer.h"

#include "core/link/steady_now.h"

#include <QtCore/QPointer>

namespace skyseal::link {

StreamPeer::StreamPeer(QIODevice &device, Path path, std::size_t queueBytes)
    : m_device(device), m_path(path), m_queueBytes(queueBytes), m_in(kChunk)
{
    m_out.reserve(kChunk);
}

bool StreamPeer::receive(Link &link, LinkListener &listener, LinkCounters &counters)
{
    const QPointer<QIODevice> device(&m_device);
    while (device && device->isOpen() && device->bytesAvailable() > 0) {
        const qint64 length = device->read(reinterpret_cast<char *>(m_in.data()), qint64(m_in.size()));
        if (length < 0)
            ++counters.rxErrors;
        if (length <= 0)
            return true;
        ++counters.rxBlocks;
        counters.rxBytes += static_cast<std::uint64_t>(length);
        const ReceivedBlock block{m_path, MutableByteView(m_in).first(static_cast<std::size_t>(length)), steadyNow()};
        listener.linkReceived(link, {&block, 1});
        if (link.state() == LinkState::Closed)
            return false;
    }
    return true;
}

void StreamPeer::send(ByteView block, LinkCounters &counters)
{
    if (m_out.size() + block.size() > kChunk)
        flush(counters);
    const std::size_t waiting = static_cast<std::size_t>(m_device.bytesToWrite()) + m_out.size();
    if (block.size() > kChunk || waiting + block.size() > m_queueBytes) {
        ++counters.txDropped;
        return;
    }
    m_out.insert(m_out.end(), block.begin(), block.end());
    ++counters.txBlocks;
}

void StreamPeer::flush(LinkCounters &counters)
{
    if (m_out.empty())
        return;
    const qint64 written = m_device.write(reinterpret_cast<const char *>(m_out.data()), qint64(m_out.size()));
    if (written == qint64(m_out.size()))
        counters.txBytes += m_out.size();
    else
        ++counters.txErrors;
    m_out.clear();
}

} // namespace skyseal::link
