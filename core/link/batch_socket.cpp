#include "core/link/batch_socket.h"

#include "core/link/address_text.h"
#include "core/link/epoll_dispatcher.h"
#include "core/link/steady_now.h"

#include <QtCore/QEvent>

#include <cerrno>
#include <cstring>
#include <functional>

#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <netinet/udp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace skyseal::link {

namespace {

constexpr std::size_t kBatch = DatagramSocket::kBatch;

// One slot for both address families, which share the field with the family.
union SocketAddress {
    sockaddr any;
    sockaddr_in four;
    sockaddr_in6 six;
};

socklen_t toSocket(const Address &from, bool ipv6, SocketAddress &to)
{
    if (!ipv6) {
        to.four = {};
        to.four.sin_family = AF_INET;
        to.four.sin_port = htons(from.port);
        std::memcpy(&to.four.sin_addr, from.ip.data() + 12, 4);
        return sizeof to.four;
    }
    to.six = {};
    to.six.sin6_family = AF_INET6;
    to.six.sin6_port = htons(from.port);
    std::memcpy(&to.six.sin6_addr, from.ip.data(), 16);
    return sizeof to.six;
}

Address fromSocket(const SocketAddress &from)
{
    Address to;
    if (from.any.sa_family == AF_INET) {
        to.ip[10] = to.ip[11] = 0xff;
        std::memcpy(to.ip.data() + 12, &from.four.sin_addr, 4);
        to.port = ntohs(from.four.sin_port);
    } else if (from.any.sa_family == AF_INET6) {
        std::memcpy(to.ip.data(), &from.six.sin6_addr, 16);
        to.port = ntohs(from.six.sin6_port);
    }
    return to;
}

/// Calls back without a signal.
class Notifier final : public QSocketNotifier
{
public:
    Notifier(int descriptor, Type which, std::function<void()> ready)
        : QSocketNotifier(descriptor, which), m_onReady(std::move(ready))
    {}

protected:
    bool event(QEvent *event) override
    {
        if (event->type() != QEvent::SockAct)
            return QSocketNotifier::event(event);
        m_onReady();
        return true;
    }

private:
    std::function<void()> m_onReady;
};

/// Address and bytes are together, so that the caches and address translations of one datagram alone are few.
struct Datagram
{
    SocketAddress address;
    std::size_t length; ///< to send
    std::array<std::uint8_t, kMaxDatagram> bytes;
};

/// Buffers of recvmmsg and sendmmsg with the pointers between them, set up once.
struct Slots
{
    Slots()
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            vectors[i] = {datagrams[i].bytes.data(), kMaxDatagram};
            headers[i] = {};
            headers[i].msg_hdr.msg_name = &datagrams[i].address;
            headers[i].msg_hdr.msg_namelen = sizeof datagrams[i].address;
            headers[i].msg_hdr.msg_iov = &vectors[i];
            headers[i].msg_hdr.msg_iovlen = 1;
        }
    }

    std::array<Datagram, kBatch> datagrams;
    std::array<iovec, kBatch> vectors;
    std::array<mmsghdr, kBatch> headers;
};

/// Messages of sendmmsg that consist of several datagrams of one size, and their control data.
struct Segments
{
    static constexpr std::size_t kMostBytes = 60'000; ///< in one piece; IP carries 65,507

    /// Joins the slots from `first` on, `run` of them; returns the number of messages.
    std::size_t join(Slots &slots, std::size_t first, std::size_t run);

    struct Control
    {
        alignas(cmsghdr) std::array<std::uint8_t, CMSG_SPACE(sizeof(std::uint16_t))> bytes;
    };
    std::array<mmsghdr, kBatch> headers;
    std::array<Control, kBatch> controls;
    std::array<std::size_t, kBatch> datagrams; ///< in each message
};

std::size_t Segments::join(Slots &slots, std::size_t first, std::size_t run)
{
    std::size_t messages = 0;
    for (std::size_t begin = 0, end = 0; begin < run; begin = end, ++messages) {
        const std::size_t slot = first + begin, size = slots.vectors[slot].iov_len;
        const auto fits = [&](std::size_t i) {
            return slots.vectors[first + i].iov_len == size && (i - begin + 1) * size <= kMostBytes
                && std::memcmp(&slots.datagrams[first + i].address, &slots.datagrams[slot].address,
                               slots.headers[slot].msg_hdr.msg_namelen)
                == 0;
        };
        for (end = begin + 1; end < run && size > 0 && fits(end);)
            ++end;
        headers[messages] = slots.headers[slot];
        datagrams[messages] = end - begin;
        if (end - begin == 1)
            continue;
        msghdr &header = headers[messages].msg_hdr;
        header.msg_iovlen = end - begin; // the vectors of the slots follow one another
        header.msg_control = controls[messages].bytes.data();
        header.msg_controllen = controls[messages].bytes.size();
        cmsghdr *control = CMSG_FIRSTHDR(&header);
        control->cmsg_level = SOL_UDP;
        control->cmsg_type = UDP_SEGMENT;
        control->cmsg_len = CMSG_LEN(sizeof(std::uint16_t));
        const auto segment = static_cast<std::uint16_t>(size);
        std::memcpy(CMSG_DATA(control), &segment, sizeof segment);
    }
    return messages;
}

} // namespace

struct BatchSocket::Buffers
{
    std::array<ReceivedBlock, kBatch> blocks;
    Slots in;
    Slots out;
    Segments segments;
};

BatchSocket::BatchSocket(bool segmented) : m_segmented(segmented), m_buffers(std::make_unique<Buffers>()) {}

BatchSocket::~BatchSocket()
{
    shut();
}

void BatchSocket::shut()
{
    for (const auto &notifier : {m_readNotifier.get(), m_writeNotifier.get()}) {
        if (notifier)
            notifier->setEnabled(false);
    }
    if (m_fd >= 0 && m_loop)
        m_loop->removeReader(m_fd);
    if (m_fd >= 0)
        ::close(m_fd);
    m_fd = -1;
}

std::optional<LinkError> BatchSocket::bind(const Address &local, int receiveBufferBytes)
{
    m_ipv6 = !isIpv4(local);
    m_fd = ::socket(m_ipv6 ? AF_INET6 : AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (m_fd < 0)
        return systemError(errno, toText(local));
    const int on = 1;
    const int off = 0;
    // Failures are ignored: the socket works with a smaller buffer and without broadcast.
    ::setsockopt(m_fd, SOL_SOCKET, SO_RCVBUF, &receiveBufferBytes, sizeof receiveBufferBytes);
    ::setsockopt(m_fd, SOL_SOCKET, SO_BROADCAST, &on, sizeof on);
    if (m_ipv6)
        ::setsockopt(m_fd, IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof off);
    // No SO_REUSEADDR: two stations could share a port, and each would receive a part of the datagrams.
    SocketAddress address;
    const socklen_t length = toSocket(local, m_ipv6, address);
    if (::bind(m_fd, &address.any, length) != 0)
        return systemError(errno, toText(local));
    m_loop = qobject_cast<EpollDispatcher *>(QAbstractEventDispatcher::instance());
    if (m_loop)
        m_loop->addReader(m_fd, *this);
    else
        m_readNotifier = std::make_unique<Notifier>(m_fd, QSocketNotifier::Read, [this] { noteReadable(); });
    m_writeNotifier = std::make_unique<Notifier>(m_fd, QSocketNotifier::Write, [this] {
        m_writeNotifier->setEnabled(false);
        m_blocked = false;
        noteWritable();
    });
    m_writeNotifier->setEnabled(false);
    return std::nullopt;
}

Address BatchSocket::local() const
{
    SocketAddress address{};
    socklen_t length = sizeof address;
    if (m_fd < 0 || ::getsockname(m_fd, &address.any, &length) != 0)
        return {};
    return fromSocket(address);
}

DatagramSocket::Batch BatchSocket::receive(LinkId id, LinkCounters &counters, std::size_t most)
{
    if (m_lone.expected())
        return receiveOne(id, counters);
    Slots &in = m_buffers->in;
    const int count = ::recvmmsg(m_fd, in.headers.data(), static_cast<unsigned>(most), MSG_DONTWAIT, nullptr);
    if (count < 0)
        return receiveFailed(counters);
    const TimePoint now = steadyNow();
    m_lone.note(now, static_cast<std::size_t>(count));
    std::size_t used = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        Datagram &datagram = in.datagrams[i];
        msghdr &header = in.headers[i].msg_hdr;
        header.msg_namelen = sizeof datagram.address;
        if (header.msg_flags & MSG_TRUNC) {
            ++counters.rxOversized;
            continue;
        }
        const std::size_t length = in.headers[i].msg_len;
        counters.rxBytes += length;
        m_buffers->blocks[used++] = {{id, fromSocket(datagram.address)}, MutableByteView(datagram.bytes).first(length), now};
    }
    counters.rxBlocks += used;
    return {std::span<const ReceivedBlock>(m_buffers->blocks.data(), used), static_cast<std::size_t>(count) < most};
}

/// If more have arrived after all, the event loop calls again at once.
DatagramSocket::Batch BatchSocket::receiveOne(LinkId id, LinkCounters &counters)
{
    Datagram &datagram = m_buffers->in.datagrams[0];
    socklen_t addressLength = sizeof datagram.address;
    const ssize_t length = ::recvfrom(m_fd, datagram.bytes.data(), datagram.bytes.size(), MSG_DONTWAIT | MSG_TRUNC,
                                      &datagram.address.any, &addressLength);
    if (length < 0)
        return receiveFailed(counters);
    const TimePoint now = steadyNow();
    m_lone.note(now, 1);
    const auto size = static_cast<std::size_t>(length); // before it was truncated
    if (size > datagram.bytes.size()) {
        ++counters.rxOversized;
        return {};
    }
    counters.rxBytes += size;
    ++counters.rxBlocks;
    m_buffers->blocks[0] = {{id, fromSocket(datagram.address)}, MutableByteView(datagram.bytes).first(size), now};
    return {std::span<const ReceivedBlock>(m_buffers->blocks.data(), 1), true};
}

DatagramSocket::Batch BatchSocket::receiveFailed(LinkCounters &counters) const
{
    // Some kernels report the ICMP error of an earlier datagram here. It only means that the peer is not up yet.
    const bool peerAbsent = errno == ECONNREFUSED;
    if (!peerAbsent && errno != EAGAIN && errno != EINTR)
        ++counters.rxErrors;
    return {{}, !peerAbsent};
}

void BatchSocket::send(const Address &to, ByteView datagram, LinkCounters &counters)
{
    if (m_queued == kBatch)
        flush(counters);
    if (m_queued == kBatch || datagram.size() > kMaxDatagram || (!m_ipv6 && !isIpv4(to))) {
        ++counters.txDropped;
        return;
    }
    Slots &out = m_buffers->out;
    const std::size_t slot = (m_first + m_queued++) % kBatch;
    toSocket(to, m_ipv6, out.datagrams[slot].address);
    out.datagrams[slot].length = datagram.size();
    std::memcpy(out.datagrams[slot].bytes.data(), datagram.data(), datagram.size());
}

/// Passes the next `run` datagrams of the ring to the system. Returns the number of accepted ones; -1 if it rejects the first.
int BatchSocket::sendRun(std::size_t run)
{
    Slots &out = m_buffers->out;
    const socklen_t addressLength = m_ipv6 ? sizeof(sockaddr_in6) : sizeof(sockaddr_in);
    if (run == 1) {
        const Datagram &one = out.datagrams[m_first];
        return ::sendto(m_fd, one.bytes.data(), one.length, MSG_DONTWAIT, &one.address.any, addressLength) < 0 ? -1 : 1;
    }
    for (std::size_t i = m_first; i < m_first + run; ++i) {
        out.vectors[i].iov_len = out.datagrams[i].length;
        out.headers[i].msg_hdr.msg_namelen = addressLength;
    }
    if (!m_segmented)
        return ::sendmmsg(m_fd, out.headers.data() + m_first, static_cast<unsigned>(run), MSG_DONTWAIT);
    Segments &segments = m_buffers->segments;
    const std::size_t messages = segments.join(out, m_first, run);
    const int sent = ::sendmmsg(m_fd, segments.headers.data(), static_cast<unsigned>(messages), MSG_DONTWAIT);
    int datagrams = sent < 0 ? -1 : 0;
    for (int i = 0; i < sent; ++i)
        datagrams += static_cast<int>(segments.datagrams[static_cast<std::size_t>(i)]);
    return datagrams;
}

void BatchSocket::flush(LinkCounters &counters)
{
    while (m_queued > 0 && !m_blocked) {
        Slots &out = m_buffers->out;
        const std::size_t run = std::min(m_queued, kBatch - m_first);
        int sent = sendRun(run);
        if (sent < 0 && m_segmented && (errno == EINVAL || errno == EIO || errno == EMSGSIZE || errno == EOPNOTSUPP)) {
            m_segmented = false; // not supported by this system or route
            continue;
        }
        if (sent < 0 && (errno == EAGAIN || errno == ENOBUFS)) {
            m_blocked = true;
            m_writeNotifier->setEnabled(true);
            return;
        }
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0) {
            // The system rejects the first datagram (no route, too long, port closed): skip it and send the others.
            ++counters.txErrors;
            sent = 1;
        } else {
            counters.txBlocks += static_cast<std::uint64_t>(sent);
            for (std::size_t i = m_first; i < m_first + static_cast<std::size_t>(sent); ++i)
                counters.txBytes += out.datagrams[i].length;
        }
        m_queued -= static_cast<std::size_t>(sent);
        // An empty queue begins anew in the first slot, which is more likely in the caches than the next one.
        m_first = m_queued == 0 ? 0 : (m_first + static_cast<std::size_t>(sent)) % kBatch;
    }
}

std::uint64_t BatchSocket::kernelDrops() const
{
    std::array<std::uint32_t, SK_MEMINFO_VARS> info{};
    socklen_t length = sizeof info;
    if (m_fd < 0 || ::getsockopt(m_fd, SOL_SOCKET, SO_MEMINFO, info.data(), &length) != 0)
        return 0;
    return info[SK_MEMINFO_DROPS];
}

} // namespace skyseal::link

#include "moc_batch_socket.cpp"
