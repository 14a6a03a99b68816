// Connects a pairing, which has no sockets, with the links. The station and the agent use the same class. I/O thread.
#pragma once

#include "core/channel/pairing.h"
#include "core/engine/common/link_pool.h"

#include <functional>
#include <optional>

namespace skyseal::engine {

class PairingDriver
{
public:
    using Notify = std::function<void(const channel::PairingEvent &)>;

    /// `random` must outlive it.
    PairingDriver(LinkPool &links, RandomSource &random, Notify notify)
        : m_links(links), m_random(random), m_notify(std::move(notify))
    {}

    /// Opens a pairing window; an open one is cancelled without a further event.
    void open(TimePoint now, channel::PairingConfig config);
    bool isOpen() const { return m_pairing && !m_over; }

    /// Returns false if the datagram does not belong to a pairing in progress.
    bool take(TimePoint now, const Path &from, ByteView datagram);
    void handleDeadline(TimePoint now);
    /// See channel::PairingConfig::callTo.
    void setCallTo(std::vector<Path> paths);
    void confirm(TimePoint now, const channel::PublicKey &key);
    void refuse(TimePoint now);
    void cancel(TimePoint now, channel::PairingEnd reason);

    /// Sends outgoing datagrams and publishes events. Call at the end of each wake-up.
    void flush();
    TimePoint nextDeadline() const { return m_pairing ? m_pairing->nextDeadline() : kNever; }

private:
    LinkPool &m_links;
    RandomSource &m_random;
    Notify m_notify;
    std::optional<channel::Pairing> m_pairing;
    bool m_over = false;
};

} // namespace skyseal::engine
