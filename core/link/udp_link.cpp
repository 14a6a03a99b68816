#include "core/link/udp_link.h"

#include "core/link/address_text.h"
#include "core/link/port_owner.h"
#include "core/link/steady_now.h"

namespace skyseal::link {

using std::chrono::duration_cast;
using std::chrono::milliseconds;

UdpLink::UdpLink(LinkUrl linkUrl, LinkId linkId, LinkListener &linkListener, LinkOptions linkOptions)
    : Link(std::move(linkUrl), linkId, linkListener, linkOptions), m_backoff(options().retryFirst, options().retryMax)
{
    m_retryTimer.setSingleShot(true);
    connect(&m_retryTimer, &QTimer::timeout, this, &UdpLink::start);
}

std::optional<Address> UdpLink::localEndpoint() const
{
    return m_socket ? std::optional(m_socket->local()) : std::nullopt;
}

std::string UdpLink::localAddress() const
{
    if (m_socket)
        return toText(m_socket->local());
    return url().isListening() ? Link::localAddress() : std::string();
}

LinkCounters UdpLink::counters() const
{
    LinkCounters out = m_counters;
    out.rxKernelDrops = m_earlierDrops + (m_socket ? m_socket->kernelDrops() : 0);
    return out;
}

void UdpLink::open()
{
    if (state() != LinkState::Closed && state() != LinkState::Failed)
        return;
    m_backoff.reset();
    setState(LinkState::Opening);
    start();
}

void UdpLink::start()
{
    m_lookup.start(url().host(), url().port(), [this](std::optional<Address> address) {
        if (address) {
            use(*address);
            return;
        }
        setState(LinkState::Waiting, {LinkErrorCode::HostUnknown, url().host(), {}});
        m_retryTimer.start(duration_cast<milliseconds>(m_backoff.next()));
    });
}

void UdpLink::use(const Address &address)
{
    const bool listening = url().isListening();
    const bool sameFamily = m_socket && isIpv4(m_socket->local()) == isIpv4(address);
    if (!sameFamily) {
        dropSocket();
        auto socket = makeDatagramSocket(options());
        const Address any = isIpv4(address) ? ipv4(0, 0) : Address{};
        if (auto failed = socket->bind(listening ? address : any, options().receiveBufferBytes)) {
            if (failed->code == LinkErrorCode::PortInUse)
                failed->detail = portOwnerText(PortKind::Udp, address.port);
            setState(LinkState::Failed, std::move(*failed));
            return;
        }
        socket->setListener(this);
        m_socket = std::move(socket);
    }
    m_backoff.reset();
    if (!listening)
        m_remote = address;
    setState(listening ? LinkState::Listening : LinkState::Connected);
}

void UdpLink::socketReadable()
{
    DatagramSocket::Batch received = m_socket->receive(id(), m_counters, m_batch);
    if (received.drained) { // the most frequent case, for which the clock is not read again
        m_batch = kLeastBatch;
        if (!received.blocks.empty())
            listener().linkReceived(*this, received.blocks);
        return;
    }
    const TimePoint start = steadyNow();
    std::size_t taken = 0;
    for (;;) {
        taken += received.blocks.size();
        if (!received.blocks.empty())
            listener().linkReceived(*this, received.blocks);
        const Duration used = steadyNow() - start;
        // Size the next batch to fit into one turn at the measured cost per datagram.
        if (taken > 0) {
            const Duration each = std::max<Duration>(used / static_cast<Duration::rep>(taken), Duration(1));
            const auto fitting = static_cast<std::size_t>(options().turn / each);
            m_batch = std::clamp(fitting, kLeastBatch, DatagramSocket::kBatch);
        }
        // The listener may close the link, so m_socket is checked after every batch.
        if (!m_socket || received.drained || used >= options().turn)
            return;
        received = m_socket->receive(id(), m_counters, m_batch);
    }
}

void UdpLink::send(const Address &to, ByteView block)
{
    const Address &target = to == Address{} ? m_remote : to;
    if (!m_socket || target.port == 0) {
        ++m_counters.txDropped;
        return;
    }
    const std::uint64_t errors = m_counters.txErrors;
    m_socket->send(target, block, m_counters);
    checkRoute(errors);
}

void UdpLink::flush()
{
    if (!m_socket)
        return;
    const std::uint64_t errors = m_counters.txErrors;
    m_socket->flush(m_counters);
    checkRoute(errors);
}

void UdpLink::checkRoute(std::uint64_t errorsBefore)
{
    // The address of a host name may have changed; resolve it again. Literal addresses cannot change.
    if (m_counters.txErrors == errorsBefore || m_lookup.isRunning() || m_retryTimer.isActive() || url().isListening()
        || parseHost(url().host(), 0))
        return;
    m_retryTimer.start(duration_cast<milliseconds>(m_backoff.next()));
}

void UdpLink::dropSocket()
{
    if (!m_socket)
        return;
    m_earlierDrops += m_socket->kernelDrops();
    // This may run inside a call of the socket: release the port now, delete the object later.
    m_socket->shut();
    m_socket->setListener(nullptr);
    m_socket.release()->deleteLater();
}

void UdpLink::close()
{
    m_lookup.abort();
    m_retryTimer.stop();
    flush();
    m_retryTimer.stop();
    dropSocket();
    m_remote = {};
    setState(LinkState::Closed);
}

} // namespace skyseal::link

#include "moc_udp_link.cpp"
