// Relay between two links that impairs the traffic like a bad radio: loss, duplicates, reordering, corruption and delay, for
// tests of protocols and vehicles. Each direction has its own Impairment. Every datagram can be logged, so that arrivals are
// compared with the log frame by frame. Lives on the thread that made it.
#pragma once

#include "core/impair/impairment.h"
#include "core/link/datagram_contents.h"
#include "core/link/make_link.h"

#include <QtCore/QTimer>

#include <functional>

namespace skyseal::link {

class Impairer : public QObject, private LinkListener
{
    Q_OBJECT

public:
    enum class Direction : std::uint8_t { Forward, Backward }; ///< from `listen` to `to`, and back

    /// Impairs each datagram; on byte streams (tcp, serial) each received chunk.
    Impairer(const LinkUrl &listen, const LinkUrl &to, const impair::Settings &settings, const LinkOptions &options = {});

    void open();
    void close();

    Link &listenLink() { return *m_sides[0].link; }
    Link &toLink() { return *m_sides[1].link; }

    struct Totals
    {
        impair::Counters counters;
        std::uint64_t unroutable = 0; ///< arrived before the other side had a peer; not part of `counters`
        /// Contents of datagrams that were dropped or duplicated: sealed units (records and frames sealed in place, without
        /// handshakes) and clear MAVLink frames. A receiver must miss exactly these.
        std::uint64_t droppedRecords = 0, droppedFrames = 0;
        std::uint64_t duplicatedRecords = 0, duplicatedFrames = 0;
    };
    Totals totals(Direction direction) const;

    /// Receives the arrival time, verdict and contents of a datagram.
    using Log = std::function<void(Direction, TimePoint, const impair::Verdict &, const DatagramContents &)>;
    /// `log` is called for every datagram that arrives; may be empty.
    void setLog(Log log) { m_log = std::move(log); }
    /// Called for every copy that is sent; `sequence` is that of its verdict.
    using DeliveryLog = std::function<void(Direction, TimePoint, std::uint64_t sequence)>;
    void setDeliveryLog(DeliveryLog log) { m_deliveryLog = std::move(log); }

Q_SIGNALS:
    /// One of the two links changed its state.
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
    Side makeSide(const LinkUrl &url, LinkId id, const impair::Settings &settings, const LinkOptions &options);

    std::array<Side, 2> m_sides;
    QTimer m_timer;
    Log m_log;
    DeliveryLog m_deliveryLog;
};

/// "forward" or "backward".
const char *name(Impairer::Direction direction);

/// One JSON object: {"event":EVENT,"t":…,"forward":{…},"backward":{…}}, t in seconds since `start`.
std::string statsJson(const char *event, const Impairer &impairer, Duration sinceStart);
/// {"event":"drop","t":…,"direction":…,"sequence":…,"bytes":…,"reason":"loss"|"queue"}
std::string dropJson(Impairer::Direction direction, Duration sinceStart, const impair::Verdict &verdict);
/// {"event":"in","t":…,"direction":…,"sequence":…,"bytes":…,"fate":"passed"|"lost"|"queue_full","duplicated":…,
/// "held_back":…,"corrupted":…,"counters":[…] (sealed units),"connection":… (of a record),"epoch":… (low bits),"frames":[[system,component,sequence],…]}
std::string arrivalJson(Impairer::Direction direction, Duration sinceStart, const impair::Verdict &verdict,
                        const DatagramContents &contents);
/// {"event":"out","t":…,"direction":…,"sequence":…}
std::string deliveryJson(Impairer::Direction direction, Duration sinceStart, std::uint64_t sequence);

} // namespace skyseal::link
