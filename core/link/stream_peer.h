// One open byte stream (a TCP connection, a serial device): chunks in, whole blocks out through a bounded queue. Used by
// every stream link, so that all of them drop and count alike.
#pragma once

#include "core/link/link.h"

#include <QtCore/QIODevice>

namespace skyseal::link {

class StreamPeer
{
public:
    /// `device` must be open, buffered and outlive this.
    StreamPeer(QIODevice &device, Path path, std::size_t queueBytes);

    const Path &path() const { return m_path; }

    /// Hands everything that has arrived to the listener. The listener may close the link; then false is returned, and
    /// this object may be gone.
    bool receive(Link &link, LinkListener &listener, LinkCounters &counters);
    /// Takes a whole block or none: half a frame would cost the receiver the next one too.
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
