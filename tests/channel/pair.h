// A ground station's endpoint and an agent's on one virtual clock and a simulated link, with an exact account of every
// sealed frame: whether the link transported it, and how often it was delivered.
#pragma once

#include "core/channel/counter_store.h"
#include "core/channel/delivery.h"
#include "core/channel/endpoint_config.h"
#include "core/channel/events.h"
#include "core/channel/sealed.h"
#include "core/channel/session_info.h"
#include "identity.h"
#include "simulated_link.h"
#include "tests/crypto/seeded_random.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>

namespace skyseal::channel {
class Endpoint;
}

namespace skyseal::test {

using namespace skyseal::channel;

/// Survives a restart of its endpoint, as a file would.
class MemoryCounterStore final : public CounterStore
{
public:
    MemoryCounterStore();
    MemoryCounterStore(const MemoryCounterStore &);
    ~MemoryCounterStore() override;

    std::optional<std::uint64_t> next() override;
    bool skipTo(std::uint64_t counter) override;
    std::uint64_t lastSeen(const channel::PublicKey &peer) override;
    bool remember(const channel::PublicKey &peer, std::uint64_t counter) override;
    Reason problem() const override { return trouble; }
    bool fails = false;
    std::string trouble;         ///< reason why nothing is stored, as on a full disk
    std::uint64_t timeOfDay = 1; ///< wall clock; no result may depend on it
    /// Simulates a file that was lost, or restored from an old copy.
    void loseOwn() { m_own = 0; }

private:
    std::uint64_t m_own = 0;
    std::map<channel::PublicKey, std::uint64_t> m_seen;
};

/// How the clock of an end runs: by `rate` seconds a second, and `offset` ahead since the last step.
struct ClockModel
{
    double rate = 1;
    Duration offset{};

    TimePoint local(TimePoint time) const { return scaled(time, rate) + offset; }
    /// The first time at which the clock shows `local`.
    TimePoint global(TimePoint local) const
    {
        if (local == kNever || local == TimePoint::min())
            return local;
        return rate == 1 ? local - offset : scaled(local - offset, 1 / rate) + Duration(2); // rounding
    }

private:
    static TimePoint scaled(TimePoint time, double rate)
    {
        const auto extra = static_cast<Duration::rep>(static_cast<double>(time.time_since_epoch().count()) * (rate - 1));
        return time + Duration(extra);
    }
};

struct PairOptions
{
    std::uint64_t seed = 1;
    WireModel link;
    Timing timing;
    FreshnessLimits freshness; ///< of both ends
    Carrier carrier = Carrier::Datagram;
    bool announceToAddress = true;             ///< otherwise to the one peer of the link, by an all-zero address
    std::shared_ptr<const Key32> presharedKey; ///< of both ends; none = they have none
    Policy ground{defaultSuites(), true, false};
    Policy air{defaultSuites(), true, false};
    /// For frames sealed in place: their traits, and a factory of real frames whose payload begins with a number. Without
    /// these, a frame is any block with a first byte of MAVLink.
    std::shared_ptr<const MessageTraits> messageTraits;
    std::function<Bytes(std::uint64_t number, std::size_t size)> makeFrame;
};

class Pair
{
public:
    explicit Pair(PairOptions options = {});
    ~Pair();

    struct End
    {
        End();
        ~End();
        const PublicKey &publicKey() const;

        std::unique_ptr<Endpoint> endpoint;
        MemoryCounterStore counters;
        std::shared_ptr<const crypto::X25519KeyPair> identity;
        channel::Policy policy;
        std::uint16_t port = 0;
        std::vector<Event> events;
        std::unordered_map<std::uint64_t, int> delivered;       ///< frame number -> how often
        std::vector<std::uint32_t> epochs;                      ///< of deliveries, in order
        std::unordered_map<std::uint64_t, Freshness> freshness; ///< frame number -> of its first delivery
        std::unordered_map<std::uint64_t, TimePoint> arrived;
        ClockModel clock;
        std::uint64_t bytesOut = 0;
        std::uint64_t datagramsOut = 0;

        /// Calls of its endpoint; those for a session are for the newest. For others, include core/channel/endpoint.h.
        std::vector<SessionId> sessions() const;
        SessionId session() const; ///< the newest; 0 without one
        bool up() const { return endpoint && !sessions().empty(); }
        std::optional<SessionInfo> sessionInfo() const;
        std::optional<SessionStats> stats() const;
        Path recordPath() const;
        Framing framing() const;
        const ReceiveCounters &unmatched() const;
        std::uint64_t strangerHashes() const;
        std::optional<Delivery> handleDatagram(TimePoint time, const Path &from, MutableByteView datagram);
        std::optional<Delivery> handleInlineFrame(TimePoint time, const Path &from, MutableByteView frame);
        Sealed seal(TimePoint time, ByteView frames, MutableByteView out);
        Sealed sealInline(TimePoint time, ByteView frame, MutableByteView out);
        void switchSuite(TimePoint time, crypto::SuiteId suite);
        void rekey(TimePoint time);
        void close(TimePoint time);
        void setPeers(TimePoint time, std::vector<Peer> peers);
        void setPolicy(TimePoint time, Policy newPolicy);
        std::optional<Transmit> pollTransmit();
        template<typename E> std::vector<E> all() const
        {
            std::vector<E> out;
            for (const Event &event : events) {
                if (const E *e = std::get_if<E>(&event))
                    out.push_back(*e);
            }
            return out;
        }
        std::size_t switches() const; ///< that were carried out
    };

    End &ground() { return ends[Ground]; }
    End &air() { return ends[Air]; }
    bool bothUp() const { return ends[Ground].up() && ends[Air].up(); }

    void start(Side side);
    void kill(Side side);

    /// Runs the clock to now + `span`; returns true if `until` ended it early.
    bool run(Duration span, const std::function<bool()> &until = {});
    /// Calls `act` every `period` from now on.
    void every(Duration period, std::function<void()> act);
    /// Cancels all calls of every().
    void stopTasks() { m_tasks.clear(); }
    void stopTraffic() { m_tasks.clear(); }

    /// Seals and sends one frame of `size` bytes (at least 9). Returns its number; 0 without a session.
    /// With PairOptions::makeFrame in place, where the session does so.
    std::uint64_t sendFrame(Side from, std::size_t size = 28);
    /// Sends the output of the endpoints and collects their events. run() includes this.
    void pump();

    /// Describes the first fault in the delivery of the frames of `side`; empty if there is none.
    std::string accountFrom(Side side) const;

    /// Carrier in which messages arrive from now on, whichever they were sent in: an attacker moves them to another carrier.
    void setArrival(Carrier carrier) { m_arrival = carrier; }

    /// The present time by the clock of an end.
    TimePoint nowAt(Side side) const { return ends[side].clock.local(now); }

    TimePoint now{};
    SimulatedLink link;
    std::array<End, 2> ends;
    std::set<std::uint64_t> sent[2]; ///< frame numbers sealed, by sender
    std::unordered_map<std::uint64_t, TimePoint> sentAt;
    std::set<std::uint64_t> dropped[2]; ///< of these, lost or damaged by the link

    Config configOf(Side side) const;
    Path pathOf(Side side) const; ///< where its datagrams come from

private:
    struct Task
    {
        TimePoint due;
        Duration period;
        std::function<void()> act;
    };
    void arrive(SentDatagram flight);
    Bytes frameWith(std::uint64_t number, std::size_t size) const;

    PairOptions m_options;
    Carrier m_arrival = m_options.carrier;
    SeededRandom m_random;
    std::vector<Task> m_tasks;
    std::uint64_t m_frames = 0;
};

} // namespace skyseal::test
