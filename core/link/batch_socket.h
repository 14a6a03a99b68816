// UDP on Linux with recvmmsg and sendmmsg: one system call for up to 64 datagrams; recvfrom and sendto for one alone, which
// cost less. An EpollDispatcher calls the socket directly, another event loop through a QSocketNotifier. With segmentation
// (udp(7), UDP_SEGMENT) datagrams of one size also go through the system's network stack as one piece, and arrive as usual.
#pragma once

#include "core/link/datagram_socket.h"
#include "core/link/lone_datagrams.h"
#include "core/link/readable_handler.h"

#include <QtCore/QPointer>
#include <QtCore/QSocketNotifier>

namespace skyseal::link {

class EpollDispatcher;

class BatchSocket final : public DatagramSocket, private ReadableHandler
{
    Q_OBJECT

public:
    explicit BatchSocket(bool segmented);
    ~BatchSocket() override;

    std::optional<LinkError> bind(const Address &local, int receiveBufferBytes) override;
    Address local() const override;
    void shut() override;
    Batch receive(LinkId id, LinkCounters &counters, std::size_t most) override;
    void send(const Address &to, ByteView datagram, LinkCounters &counters) override;
    void flush(LinkCounters &counters) override;
    std::uint64_t kernelDrops() const override;

private:
    struct Buffers;

    void handleReadable() override { noteReadable(); }
    Batch receiveOne(LinkId id, LinkCounters &counters);
    Batch receiveFailed(LinkCounters &counters) const;
    int sendRun(std::size_t run);

    int m_fd = -1;
    bool m_segmented;
    bool m_ipv6 = false;
    bool m_blocked = false;  ///< the send buffer of the system is full; m_writeNotifier signals when it has room
    std::size_t m_first = 0; ///< oldest queued datagram, in the ring of kBatch
    std::size_t m_queued = 0;
    LoneDatagrams m_lone;
    std::unique_ptr<Buffers> m_buffers;
    QPointer<EpollDispatcher> m_loop;                ///< calls handleReadable(); null in other loops
    std::unique_ptr<QSocketNotifier> m_readNotifier; ///< in other loops
    std::unique_ptr<QSocketNotifier> m_writeNotifier;
};

} // namespace skyseal::link
