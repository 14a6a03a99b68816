// One open byte stream (TCP connection, serial device): receives chunks, sends whole blocks through a bounded queue. Shared
// by the stream links, so that all of them drop and count blocks in the same way.
#pragma once

#include "core/link/link.h"

#include <QtCore/QIODevice>

namespace skyseal::link {

inline constexpr qint64 kTcpReadBuffer = 256 << 10; ///< bounds the bytes of one wake-up

class StreamPeer
{
public:
    /// `device` must be open and buffered, and outlive this object.
    StreamPeer(QIODevice &device, Path path, std::size_t queueBytes);

    const Path &path() const { return m_path; }

    /// Passes all received bytes to the listener. Returns false when the listener closed the link; this object may be
    /// deleted then.
    bool receive(Link &link, LinkListener &listener, LinkCounters &counters);
    /// Queues the whole block or drops it: half a frame would make the receiver lose the next one as well.
    void send(ByteView block, LinkCounters &counters);
    void flush(LinkCounters &counters);

private:
    static constexpr std::size_t kChunk = 64 << 10;

    QIODevice &m_device;
    Path m_path;
    std::size_t m_queueBytes;
    Bytes m_in;
    Bytes m_out;
};

} // namespace skyseal::link
