// The seam between the UDP link and the two ways to move datagrams: batches straight from the system (Linux), or
// QUdpSocket anywhere. Both deliver the same; one costs a quarter of the other.
#pragma once

#include "core/link/link.h"

#include <QtCore/QObject>

#include <memory>

namespace skyseal::link {

/// A bound, non-blocking UDP socket with preallocated buffers.
class DatagramSocket : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t kBatch = 64;

    /// Binds exclusively: a port that anyone holds is an error. [::] serves IPv4 as well.
    virtual std::optional<LinkError> bind(const Address &local, int receiveBufferBytes) = 0;
    virtual Address local() const = 0;
    /// Gives the port back at once; buffers stay, so that a caller may be inside receive()'s views.
    virtual void shut() = 0;

    /// Up to `most` (1 to kBatch) datagrams that wait now; the views hold until the next call. Fewer (even none) means
    /// that the socket is drained. Datagrams that are too long are counted and left out.
    struct Batch
    {
        std::span<const ReceivedBlock> blocks;
        bool drained = true;
    };
    virtual Batch receive(LinkId id, LinkCounters &counters, std::size_t most) = 0;

    /// Queues one datagram, sending the queue first when it is full.
    virtual void send(const Address &to, ByteView datagram, LinkCounters &counters) = 0;
    /// Sends what is queued as far as the system takes it; the rest goes when it takes more.
    virtual void flush(LinkCounters &counters) = 0;
    /// Datagrams that the system dropped on receive so far, 0 where it does not tell.
    virtual std::uint64_t kernelDrops() const { return 0; }

Q_SIGNALS:
    void readable();
    void writable();
};

/// The batching socket where the system has one and `portable` is false, otherwise QUdpSocket.
std::unique_ptr<DatagramSocket> makeDatagramSocket(bool portable);

} // namespace skyseal::link
