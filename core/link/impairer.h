// Relay between two links that impairs the traffic like a bad radio: loss, duplicates, reordering, corruption and delay, for
// tests of protocols and vehicles. Each direction has its own Impairment. Every datagram can be logged, so that tests can
// compare the arrivals with the log frame by frame. Lives on the thread that created it.
#pragma once

#include "core/impair/impairment.h"
#include "core/link/link.h"

#include <QtCore/QTimer>

#include <functional>

namespace skyseal::link {

class Impairer : public QObject, private LinkListener
{
    Q_OBJECT

public:
    enum class Direction : std::uint8_t { Forward, Backward }; ///< from `listen` to `to`, and back

    /// Impairs each datagram; on byte streams (tcp, serial) each received chunk.
    Impairer(const LinkUrl &listen, const LinkUrl &to, const impair::ImpairmentSettings &settings,
             const LinkOptions &options = {});

    void open();
    void close();

    Link &listenLink() { return *m_sides[0].link; }
    Link &toLink() { return *m_sides[1].link; }

    struct Totals
    {
        impair::Counters counters;
        std::uint64_t unroutable = 0; ///< arrived before the other side had a peer; not part of `counters`
    };
    Totals totals(Direction direction) const;

    /// Receives the arrival time and verdict of a datagram, and its bytes as they arrived.
    using Log = std::function<void(Direction, TimePoint, const impair::Treatment &, ByteView datagram)>;
    /// `log` is called for every datagram that arrives; may be empty.
    void setLog(Log log) { m_log = std::move(log); }
    /// Called for every copy that is sent; `sequence` is that of its verdict.
    using DeliveryLog = std::function<void(Direction, TimePoint, std::uint64_t sequence)>;
    void setDeliveryLog(DeliveryLog log) { m_deliveryLog = std::move(log); }

Q_SIGNALS:
    /// Emitted when one of the two links has changed its state.
    void linkStateChanged(skyseal::link::Link &link);

private:
    struct Side
    {
        std::unique_ptr<Link> link;
        impair::Impairment outgoing; ///< towards the peer of this side
        Address peer;                ///< the latest sender, for links without a fixed remote
        Totals totals;               ///< without `counters`, which the impairment keeps
    };

    void linkReceived(Link &link, std::span<const ReceivedBlock> blocks) override;
    void linkPeerJoined(Link &link, const Path &path) override;
    bool hasPeer(const Side &side) const;
    void take(const ReceivedBlock &block, Direction direction, Side &target);
    void release();
    Side makeSide(const LinkUrl &url, LinkId id, const impair::ImpairmentSettings &settings, const LinkOptions &options);

    std::array<Side, 2> m_sides;
    QTimer m_timer;
    Log m_log;
    DeliveryLog m_deliveryLog;
};

} // namespace skyseal::link
