#include "tests/support/udp_wire.h"

namespace skyseal::test {

UdpWire::UdpWire(std::uint16_t target, Listener listener)
    : m_target(target), m_listener(std::move(listener)), m_thread([this] { run(); })
{}

UdpWire::~UdpWire()
{
    m_stop = true;
    m_thread.join();
}

void UdpWire::inject(Way way, Bytes datagram)
{
    const std::lock_guard lock(m_mutex);
    m_injected.emplace_back(way, std::move(datagram));
}

void UdpWire::run()
{
    constexpr int kPatienceMs = 20; // with what comes from other threads
    while (!m_stop) {
        if (m_move.exchange(false))
            m_far = std::make_unique<BareSocket>();
        std::array<pollfd, 2> waiting{pollfd{m_near.fd(), POLLIN, 0}, pollfd{m_far->fd(), POLLIN, 0}};
        ::poll(waiting.data(), waiting.size(), kPatienceMs);
        if (waiting[0].revents)
            forward(Way::Onward);
        if (waiting[1].revents)
            forward(Way::Back);
        sendInjected();
    }
}

void UdpWire::forward(Way way)
{
    BareSocket &from = way == Way::Onward ? m_near : *m_far;
    const std::size_t count = from.receive();
    if (way == Way::Onward && count > 0)
        m_source = from.senderPort(count - 1);
    if (!(way == Way::Onward ? m_onward : m_back))
        return;
    std::array<ByteView, BareSocket::kBatch> datagrams;
    for (std::size_t i = 0; i < count; ++i) {
        datagrams[i] = from.received(i);
        m_listener(way, datagrams[i]);
    }
    send(way, std::span(datagrams).first(count));
}

void UdpWire::sendInjected()
{
    std::vector<std::pair<Way, Bytes>> injected;
    {
        const std::lock_guard lock(m_mutex);
        injected.swap(m_injected);
    }
    for (const auto &[way, datagram] : injected) {
        const ByteView view(datagram);
        send(way, {&view, 1});
    }
}

void UdpWire::send(Way way, std::span<const ByteView> datagrams)
{
    if (way == Way::Onward)
        m_far->send(m_target, datagrams);
    else if (m_source != 0)
        m_near.send(m_source, datagrams);
}

} // namespace skyseal::test
