// The machine under an engine, simulated: the steady clock, Qt's timers, random bytes and links. The linker puts the clock, the
// timers and the random source in place of the real ones (--wrap, see CMakeLists.txt); the links are of a type of their own.
#pragma once

#include "core/link/link.h"

#include <memory>
#include <vector>

namespace skyseal::test {

struct SentBlock
{
    LinkId link{};
    Address to;
    Bytes bytes;
};

class SimulatedHost
{
public:
    static SimulatedHost &instance();

    /// The state before a run: no timers, no links, the same time and the same random bytes each time.
    void reset();
    TimePoint now() const { return m_now; }
    /// The time for the engine. Each reading takes a microsecond, so that a loop that waits for the clock comes to its end.
    TimePoint readClock();
    /// Lets the time pass; timers that are due fire in their order.
    void advance(Duration span);

    /// "udpin:", "udpout:" and "tcpin:" with simulated links. A udpout link has the remote remoteOf(), whatever its URL says.
    static link::LinkUrl url(std::string_view text);
    static Address remoteOf(LinkId link);
    /// A block arrives at a link of the engine.
    void receive(LinkId link, const Address &from, ByteView bytes);
    /// The stream from this address to a link of the engine ends, and another begins.
    void reconnect(LinkId link, const Address &from);
    /// Blocks that the engine sent since the last call.
    std::vector<SentBlock> takeSent() { return std::move(m_sent); }

private:
    TimePoint m_now;
    std::vector<SentBlock> m_sent;

    friend class HostLink;
};

} // namespace skyseal::test
