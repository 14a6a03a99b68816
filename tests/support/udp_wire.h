// A UDP path between two programs of 127.0.0.1, in a thread of its own, so that a test that waits delays nothing: forwards
// both ways, shows every datagram to a listener, can be cut, changes its address towards the target as a NAT does, and sends
// datagrams of others from the address of either end.
#pragma once

#include "tests/support/bare_socket.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace skyseal::test {

class UdpWire
{
public:
    enum class Way : std::uint8_t { Onward, Back }; ///< to the target, and from it
    /// Called in the wire's thread.
    using Listener = std::function<void(Way way, ByteView datagram)>;

    UdpWire(std::uint16_t target, Listener listener);
    ~UdpWire();
    UdpWire(const UdpWire &) = delete;
    UdpWire &operator=(const UdpWire &) = delete;

    /// What the source takes for the target's port.
    std::uint16_t port() const { return m_near.port(); }
    /// A way that is closed drops what is sent; the listener does not hear of it.
    void setOpen(bool onward, bool back)
    {
        m_onward = onward;
        m_back = back;
    }
    /// From now on the target sees another address.
    void move() { m_move = true; }
    void inject(Way way, Bytes datagram);

private:
    void run();
    void forward(Way way);
    void sendInjected();
    void send(Way way, std::span<const ByteView> datagrams);

    const std::uint16_t m_target;
    const Listener m_listener;
    BareSocket m_near;
    std::unique_ptr<BareSocket> m_far = std::make_unique<BareSocket>(); ///< of the thread
    std::uint16_t m_source = 0;                                         ///< of the thread; 0: unknown
    std::mutex m_mutex;                                                 ///< of the next one
    std::vector<std::pair<Way, Bytes>> m_injected;
    std::atomic<bool> m_onward{true}, m_back{true}, m_move{false}, m_stop{false};
    std::thread m_thread;
};

} // namespace skyseal::test
