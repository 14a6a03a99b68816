// A plain UDP socket of 127.0.0.1 with batches, as small as it can be: the system calls alone, against which links and
// engines are measured, and the far end of tests that count.
#pragma once

#include "core/base/bytes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace skyseal::test {

class BareSocket
{
public:
    static constexpr std::size_t kBatch = 64;
    static constexpr int kReceiveBuffer = 4 << 20;

    BareSocket() : m_fd(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0))
    {
        const sockaddr_in any = loopback(0);
        if (m_fd < 0 || ::bind(m_fd, reinterpret_cast<const sockaddr *>(&any), sizeof any) != 0)
            std::abort();
        ::setsockopt(m_fd, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer);
        wire(m_in);
        wire(m_out);
    }
    ~BareSocket() { ::close(m_fd); }
    BareSocket(const BareSocket &) = delete;
    BareSocket &operator=(const BareSocket &) = delete;

    int fd() const { return m_fd; }
    std::uint16_t port() const
    {
        sockaddr_in address{};
        socklen_t length = sizeof address;
        ::getsockname(m_fd, reinterpret_cast<sockaddr *>(&address), &length);
        return ntohs(address.sin_port);
    }

    /// Sends all of them, in as few calls as can be.
    void send(std::uint16_t port, std::span<const ByteView> datagrams)
    {
        while (!datagrams.empty()) {
            const std::size_t count = std::min(datagrams.size(), kBatch);
            for (std::size_t i = 0; i < count; ++i) {
                m_out.vectors[i] = {const_cast<std::uint8_t *>(datagrams[i].data()), datagrams[i].size()};
                m_out.addresses[i] = loopback(port);
            }
            sendBatch(m_out, count);
            datagrams = datagrams.subspan(count);
        }
    }

    /// At most kBatch datagrams, which then lie in `received`; 0 when there was none.
    std::size_t receive()
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            m_in.vectors[i] = {m_bytes[i].data(), m_bytes[i].size()};
            m_in.headers[i].msg_hdr.msg_namelen = sizeof m_in.addresses[i];
        }
        const int count = ::recvmmsg(m_fd, m_in.headers.data(), kBatch, MSG_DONTWAIT, nullptr);
        return count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    MutableByteView received(std::size_t i) { return MutableByteView(m_bytes[i]).first(m_in.headers[i].msg_len); }

    std::uint16_t senderPort(std::size_t i) const { return ntohs(m_in.addresses[i].sin_port); }

    /// Forwards the datagrams of the last receive(): the minimum work of any forwarder.
    void forward(std::uint16_t port, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i) {
            m_in.vectors[i].iov_len = m_in.headers[i].msg_len;
            m_in.addresses[i] = loopback(port);
        }
        sendBatch(m_in, count);
    }

    bool waitReadable(int milliseconds) { return waitReadable(std::chrono::milliseconds(milliseconds)); }
    bool waitReadable(std::chrono::nanoseconds most)
    {
        const auto whole = std::chrono::floor<std::chrono::seconds>(most);
        const timespec limit{whole.count(), (most - whole).count()};
        pollfd waiting{m_fd, POLLIN, 0};
        return ::ppoll(&waiting, 1, &limit, nullptr) > 0;
    }

private:
    struct Batch
    {
        std::array<mmsghdr, kBatch> headers{};
        std::array<iovec, kBatch> vectors{};
        std::array<sockaddr_in, kBatch> addresses{};
    };

    static sockaddr_in loopback(std::uint16_t port)
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return address;
    }

    static void wire(Batch &batch)
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            batch.headers[i].msg_hdr.msg_iov = &batch.vectors[i];
            batch.headers[i].msg_hdr.msg_iovlen = 1;
            batch.headers[i].msg_hdr.msg_name = &batch.addresses[i];
            batch.headers[i].msg_hdr.msg_namelen = sizeof batch.addresses[i];
        }
    }

    void sendBatch(Batch &batch, std::size_t count)
    {
        for (std::size_t sent = 0; sent < count;) {
            const int now = ::sendmmsg(m_fd, batch.headers.data() + sent, static_cast<unsigned>(count - sent), 0);
            if (now <= 0)
                std::abort();
            sent += static_cast<std::size_t>(now);
        }
    }

    int m_fd;
    Batch m_in, m_out;
    std::array<std::array<std::uint8_t, 2048>, kBatch> m_bytes{};
};

} // namespace skyseal::test
