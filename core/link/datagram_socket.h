// Interface of the UDP link to its two implementations: system calls for batches of datagrams (Linux), and QUdpSocket for
// other systems. Both behave alike; batches cost about a quarter of the CPU time.
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

    /// Called from the event loop, directly: signals would cost several times as much.
    class Listener
    {
    public:
        virtual void socketReadable() = 0;
        virtual void socketWritable() = 0; ///< the queue can be flushed further

    protected:
        ~Listener() = default;
    };
    /// Null: no further calls.
    void setListener(Listener *listener) { m_listener = listener; }

    /// Binds exclusively: fails when another socket holds the port. [::] receives IPv4 as well.
    virtual std::optional<LinkError> bind(const Address &local, int receiveBufferBytes) = 0;
    virtual Address local() const = 0;
    /// Releases the port at once. Keeps the buffers, since a caller may still use the views of receive().
    virtual void shut() = 0;

    /// Receives up to `most` (1 to kBatch) datagrams without waiting. The views are valid until the next call. Oversized
    /// datagrams are dropped and counted.
    struct Batch
    {
        std::span<const ReceivedBlock> blocks;
        bool drained = true; ///< the receive queue of the system was empty
    };
    virtual Batch receive(LinkId id, LinkCounters &counters, std::size_t most) = 0;

    /// Queues one datagram; flushes a full queue first.
    virtual void send(const Address &to, ByteView datagram, LinkCounters &counters) = 0;
    /// Sends the queue until the system's buffer is full; the rest follows when it has room (see socketWritable()).
    virtual void flush(LinkCounters &counters) = 0;
    /// Datagrams that the system dropped on receive so far; 0 where the system does not report them.
    virtual std::uint64_t kernelDrops() const { return 0; }

protected:
    void noteReadable()
    {
        if (m_listener)
            m_listener->socketReadable();
    }
    void noteWritable()
    {
        if (m_listener)
            m_listener->socketWritable();
    }

private:
    Listener *m_listener = nullptr;
};

/// Returns a BatchSocket on Linux unless LinkOptions::portableUdp is set, otherwise a QtDatagramSocket.
std::unique_ptr<DatagramSocket> makeDatagramSocket(const LinkOptions &options);

} // namespace skyseal::link
