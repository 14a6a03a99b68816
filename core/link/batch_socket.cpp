#include "core/link/batch_socket.h"

#include "core/link/address_text.h"
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

/// Buffers of recvmmsg and sendmmsg with the pointers between them, set up once.
struct Slots
{
    Slots()
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            vectors[i] = {bytes[i].data(), bytes[i].size()};
            headers[i] = {};
            headers[i].msg_hdr.msg_name = &addresses[i];
            headers[i].msg_hdr.msg_namelen = sizeof addresses[i];
            headers[i].msg_hdr.msg_iov = &vectors[i];
            headers[i].msg_hdr.msg_iovlen = 1;
        }
    }

    std::array<mmsghdr, kBatch> headers;
    std::array<iovec, kBatch> vectors;
    std::array<SocketAddress, kBatch> addresses;
    std::array<std::array<std::uint8_t, kMaxDatagram>, kBatch> bytes;
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
                && std::memcmp(&slots.addresses[first + i], &slots.addresses[slot], slots.headers[slot].msg_hdr.msg_namelen)
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
    Slots in;
    Slots out;
    Segments segments;
    std::array<ReceivedBlock, kBatch> blocks;
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
    Slots &in = m_buffers->in;
    const int count = ::recvmmsg(m_fd, in.headers.data(), static_cast<unsigned>(most), MSG_DONTWAIT, nullptr);
    if (count < 0) {
        // Some kernels report the ICMP error of an earlier datagram here. It only means that the peer is not up yet.
        const bool peerAbsent = errno == ECONNREFUSED;
        if (!peerAbsent && errno != EAGAIN && errno != EINTR)
            ++counters.rxErrors;
        return {{}, !peerAbsent};
    }
    const TimePoint now = steadyNow();
    std::size_t used = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        msghdr &header = in.headers[i].msg_hdr;
        header.msg_namelen = sizeof in.addresses[i];
        if (header.msg_flags & MSG_TRUNC) {
            ++counters.rxOversized;
            continue;
        }
        const std::size_t length = in.headers[i].msg_len;
        counters.rxBytes += length;
        m_buffers->blocks[used++] = {{id, fromSocket(in.addresses[i])}, MutableByteView(in.bytes[i]).first(length), now};
    }
    counters.rxBlocks += used;
    return {std::span<const ReceivedBlock>(m_buffers->blocks.data(), used), static_cast<std::size_t>(count) < most};
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
    std::memcpy(out.bytes[slot].data(), datagram.data(), datagram.size());
    out.vectors[slot].iov_len = datagram.size();
    out.headers[slot].msg_hdr.msg_namelen = toSocket(to, m_ipv6, out.addresses[slot]);
}

/// Passes the next `run` datagrams of the ring to the system. Returns the number of accepted ones; -1 if it rejects the first.
int BatchSocket::sendRun(std::size_t run)
{
    Slots &out = m_buffers->out;
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
                counters.txBytes += out.vectors[i].iov_len;
        }
        m_first = (m_first + static_cast<std::size_t>(sent)) % kBatch;
        m_queued -= static_cast<std::size_t>(sent);
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
