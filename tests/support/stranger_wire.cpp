#include "tests/support/stranger_wire.h"

#include "core/channel/cobs.h"
#include "core/channel/tunnel_parts.h"
#include "core/channel/wire_format.h"
#include "core/link/steady_now.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/support/bare_socket.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <utility>

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

namespace skyseal::test {

using namespace std::chrono_literals;

namespace {

constexpr Duration kTick = 250us;
constexpr std::size_t kTicksASecond = 4000;

sockaddr_in loopback(std::uint16_t port)
{
    sockaddr_in out{};
    out.sin_family = AF_INET;
    out.sin_port = htons(port);
    out.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return out;
}

class Socket
{
public:
    Socket() = default;
    explicit Socket(int fd) : m_fd(fd) {}
    Socket(Socket &&other) noexcept : m_fd(std::exchange(other.m_fd, -1)) {}
    Socket &operator=(Socket &&other) noexcept
    {
        std::swap(m_fd, other.m_fd);
        return *this;
    }
    ~Socket()
    {
        if (m_fd >= 0)
            ::close(m_fd);
    }

    static Socket open(int type)
    {
        Socket out(::socket(AF_INET, type | SOCK_CLOEXEC, 0));
        const sockaddr_in any = loopback(0);
        if (out.m_fd < 0 || ::bind(out.m_fd, reinterpret_cast<const sockaddr *>(&any), sizeof any) != 0)
            std::abort();
        return out;
    }
    static Socket connected(std::uint16_t port)
    {
        Socket out = open(SOCK_STREAM);
        const sockaddr_in to = loopback(port);
        if (::connect(out.m_fd, reinterpret_cast<const sockaddr *>(&to), sizeof to) != 0)
            std::abort();
        out.sendAtOnce();
        return out;
    }
    void sendAtOnce()
    {
        const int on = 1;
        ::setsockopt(m_fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    }
    std::uint16_t port() const
    {
        sockaddr_in address{};
        socklen_t length = sizeof address;
        ::getsockname(m_fd, reinterpret_cast<sockaddr *>(&address), &length);
        return ntohs(address.sin_port);
    }
    int fd() const { return m_fd; }
    bool isOpen() const { return m_fd >= 0; }

    void sendTo(std::uint16_t to, ByteView bytes) const
    {
        const sockaddr_in address = loopback(to);
        ::sendto(m_fd, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr *>(&address), sizeof address);
    }
    /// Blocks until all is written, or the other end is gone.
    void write(ByteView bytes) const
    {
        while (!bytes.empty()) {
            const ssize_t written = ::send(m_fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (written <= 0)
                return;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
    }

private:
    int m_fd = -1;
};

bool isRecord(ByteView message)
{
    using channel::DatagramKind;
    return !message.empty() && channel::isOurs(message[0])
        && (channel::kindOf(message[0]) == DatagramKind::Record || channel::kindOf(message[0]) == DatagramKind::SingleRecord);
}

} // namespace

Bytes onTheWire(Carrier carrier, ByteView message)
{
    switch (carrier) {
    case Carrier::Datagram: break;
    case Carrier::Serial: {
        Bytes out(channel::kMaxCobs);
        out.resize(channel::writeCobs(message, out));
        return out;
    }
    case Carrier::Tunnel: {
        mavlink::Tunnel tunnel{.payload_type = channel::kTunnelPayloadType};
        tunnel.payload_length = static_cast<std::uint8_t>(std::min(message.size(), tunnel.payload.size()));
        std::copy_n(message.begin(), tunnel.payload_length, tunnel.payload.begin());
        if (channel::isPadded(message))
            tunnel.payload.back() = channel::kTunnelPadding;
        mavlink::FrameWriter writer(1, mavlink::MAV_COMP_ID_ONBOARD_COMPUTER);
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = writer.write(tunnel, buffer);
        return {frame.begin(), frame.end()};
    }
    }
    return {message.begin(), message.end()};
}

/// The sockets towards both ends.
class StrangerWire::Ends
{
public:
    Ends(Carrier carrier, Target target, std::uint16_t stationPort)
        : m_carrier(carrier), m_target(target), m_stationPort(stationPort),
          m_agentSide(Socket::open(isStream() ? SOCK_STREAM : SOCK_DGRAM))
    {
        if (isStream()) {
            ::listen(m_agentSide.fd(), 1);
            if (target == Target::Station)
                m_stranger = Socket::connected(stationPort);
        } else {
            m_stationSide = Socket::open(SOCK_DGRAM);
        }
    }

    std::uint16_t port() const { return m_agentSide.port(); }
    /// Forwards what arrives until `due`. `note(isFromAgent, message)` is called for each message of the channel.
    template<typename Note> void forwardUntil(TimePoint due, Note &&note)
    {
        do {
            const Duration left = std::max(due - steadyNow(), Duration());
            const timespec time{0, static_cast<long>(std::min<Duration>(left, 100ms).count())};
            std::array<pollfd, 2> waiting{pollfd{fromAgent(), POLLIN, 0}, pollfd{m_stationSide.fd(), POLLIN, 0}};
            if (::ppoll(waiting.data(), waiting.size(), &time, nullptr) <= 0)
                continue;
            if (waiting[0].revents)
                forward(true, note);
            if (waiting[1].revents)
                forward(false, note);
        } while (steadyNow() < due);
    }
    /// Sends the stranger's messages to the target. Returns false while that is not possible.
    bool send(std::span<const Bytes> messages)
    {
        if (isStream()) {
            if (m_target == Target::Agent && (!m_agent.isOpen() || !m_atBoundary))
                return false;
            m_joined.clear();
            for (const Bytes &message : messages) {
                m_joined.insert(m_joined.end(), message.begin(), message.end());
                if (message.back() != 0)
                    m_joined.push_back(0); // the next frame of the session begins anew
            }
            (m_target == Target::Agent ? m_agent : m_stranger).write(m_joined);
            return true;
        }
        const std::uint16_t to = m_target == Target::Agent ? m_agentPort : m_stationPort;
        if (to == 0)
            return false;
        m_views.assign(messages.begin(), messages.end());
        m_datagrams.send(to, m_views);
        return true;
    }

private:
    bool isStream() const { return m_carrier == Carrier::Serial; }
    int fromAgent() const { return m_agent.isOpen() ? m_agent.fd() : m_agentSide.fd(); }

    template<typename Note> void forward(bool isFromAgent, Note &&note)
    {
        if (isStream() && isFromAgent && !m_agent.isOpen()) {
            m_agent = Socket(::accept(m_agentSide.fd(), nullptr, nullptr));
            m_agent.sendAtOnce();
            m_stationSide = Socket::connected(m_stationPort);
            return;
        }
        sockaddr_in from{};
        socklen_t length = sizeof from;
        const ssize_t size = ::recvfrom(isFromAgent ? fromAgent() : m_stationSide.fd(), m_bytes.data(), m_bytes.size(),
                                        MSG_DONTWAIT, reinterpret_cast<sockaddr *>(&from), &length);
        if (size <= 0)
            return;
        const ByteView bytes = ByteView(m_bytes).first(static_cast<std::size_t>(size));
        tap(isFromAgent, bytes, note);
        if (isStream()) {
            (isFromAgent ? m_stationSide : m_agent).write(bytes);
            m_atBoundary = isFromAgent ? m_atBoundary : bytes.back() == 0;
        } else if (isFromAgent) {
            m_agentPort = ntohs(from.sin_port);
            m_stationSide.sendTo(m_stationPort, bytes);
        } else if (m_agentPort != 0) {
            m_agentSide.sendTo(m_agentPort, bytes);
        }
    }

    template<typename Note> void tap(bool isFromAgent, ByteView bytes, Note &&note)
    {
        switch (m_carrier) {
        case Carrier::Datagram: note(isFromAgent, bytes); break;
        case Carrier::Serial:
            m_cobs[isFromAgent].feed(bytes, [&](MutableByteView message) { note(isFromAgent, message); });
            break;
        case Carrier::Tunnel:
            mavlink::scanFrames(bytes, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
                if (!item.frame || item.frame->messageId() != mavlink::Tunnel::kId)
                    return;
                const mavlink::Tunnel tunnel = mavlink::Tunnel::decode(item.frame->payload());
                note(isFromAgent, ByteView(tunnel.payload).first(std::min<std::size_t>(tunnel.payload_length, 128)));
            });
            break;
        }
    }

    const Carrier m_carrier;
    const Target m_target;
    const std::uint16_t m_stationPort;
    Socket m_agentSide; ///< where the agent sends to; with TCP it only accepts
    Socket m_agent;     ///< the agent's connection
    Socket m_stationSide;
    Socket m_stranger;      ///< its own stream to the station
    BareSocket m_datagrams; ///< the stranger's
    std::vector<ByteView> m_views;
    std::uint16_t m_agentPort = 0;
    bool m_atBoundary = true;                  ///< the stream to the agent is between two COBS frames
    std::array<channel::CobsReader, 2> m_cobs; ///< by isFromAgent
    Bytes m_joined;
    std::array<std::uint8_t, 65536> m_bytes;
};

StrangerWire::StrangerWire(Carrier carrier, Target target, std::uint16_t stationPort)
    : m_target(target), m_ends(std::make_unique<Ends>(carrier, target, stationPort)), m_thread([this] { run(); })
{}

StrangerWire::~StrangerWire()
{
    m_stop = true;
    m_thread.join();
}

std::uint16_t StrangerWire::port() const
{
    return m_ends->port();
}

Bytes StrangerWire::record() const
{
    const std::lock_guard lock(m_mutex);
    return m_record;
}

std::optional<channel::PairingToken> StrangerWire::token() const
{
    const std::lock_guard lock(m_mutex);
    return m_token;
}

void StrangerWire::flood(std::shared_ptr<const std::vector<Bytes>> messages)
{
    const std::lock_guard lock(m_mutex);
    m_messages = std::move(messages);
    m_next = 0;
}

void StrangerWire::run()
{
    // It represents other machines and must not use CPU time of the program that is measured.
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 10);
    for (TimePoint due = steadyNow(); !m_stop; due += kTick) {
        m_ends->forwardUntil(due, [this](bool isFromAgent, ByteView message) { note(isFromAgent, message); });
        if (!inject())
            due = steadyNow();
    }
}

void StrangerWire::note(bool isFromAgent, ByteView message)
{
    const bool isToTarget = isFromAgent == (m_target == Target::Station);
    const auto token = isFromAgent ? channel::calledToken(message) : std::nullopt;
    const std::lock_guard lock(m_mutex);
    if (isToTarget && isRecord(message))
        m_record.assign(message.begin(), message.end());
    if (token)
        m_token = token;
}

/// Returns false while nothing is to be sent.
bool StrangerWire::inject()
{
    std::shared_ptr<const std::vector<Bytes>> messages;
    {
        const std::lock_guard lock(m_mutex);
        messages = m_messages;
    }
    if (!messages || messages->empty())
        return false;
    const std::size_t count = (messages->size() + kTicksASecond - 1) / kTicksASecond;
    const std::size_t at = m_next % messages->size(), end = std::min(at + count, messages->size());
    if (m_ends->send(std::span(*messages).subspan(at, end - at))) {
        m_next = end;
        m_sent += end - at;
    }
    return true;
}

} // namespace skyseal::test
