#include "pair.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"
#include "core/channel/endpoint.h"
#include "core/crypto/x25519.h"

#include <algorithm>

namespace skyseal::test {

MemoryCounterStore::MemoryCounterStore() = default;
MemoryCounterStore::MemoryCounterStore(const MemoryCounterStore &) = default;
MemoryCounterStore::~MemoryCounterStore() = default;

std::optional<std::uint64_t> MemoryCounterStore::next()
{
    return ++m_own;
}

bool MemoryCounterStore::skipTo(std::uint64_t counter)
{
    m_own = std::max(m_own, counter);
    return true;
}

std::uint64_t MemoryCounterStore::lastSeen(const channel::PublicKey &peer)
{
    return m_seen[peer];
}

bool MemoryCounterStore::remember(const channel::PublicKey &peer, std::uint64_t counter)
{
    if (fails)
        return false;
    m_seen[peer] = counter;
    return true;
}

Pair::End::End() = default;
Pair::End::~End() = default;

const PublicKey &Pair::End::publicKey() const
{
    return identity->publicKey;
}

std::vector<SessionId> Pair::End::sessions() const
{
    return endpoint->sessions();
}

SessionId Pair::End::session() const
{
    const auto all = endpoint->sessions();
    return all.empty() ? SessionId{} : all.back();
}

std::optional<SessionInfo> Pair::End::sessionInfo() const
{
    return endpoint->sessionInfo(session());
}

std::optional<SessionStats> Pair::End::stats() const
{
    return endpoint->stats(session());
}

Path Pair::End::recordPath() const
{
    return endpoint->recordPath(session());
}

Framing Pair::End::framing() const
{
    return endpoint->framing(session());
}

const ReceiveCounters &Pair::End::unmatched() const
{
    return endpoint->unmatched();
}

std::uint64_t Pair::End::strangerHashes() const
{
    return endpoint->strangerHashes();
}

std::optional<Delivery> Pair::End::handleDatagram(TimePoint time, const Path &from, MutableByteView datagram)
{
    return endpoint->handleDatagram(time, from, datagram);
}

std::optional<Delivery> Pair::End::handleInlineFrame(TimePoint time, const Path &from, MutableByteView frame)
{
    return endpoint->handleInlineFrame(time, from, frame);
}

Sealed Pair::End::seal(TimePoint time, ByteView frames, MutableByteView out)
{
    return endpoint->seal(time, session(), frames, out);
}

Sealed Pair::End::sealInline(TimePoint time, ByteView frame, MutableByteView out)
{
    return endpoint->sealInline(time, session(), frame, out);
}

void Pair::End::switchSuite(TimePoint time, crypto::SuiteId suite)
{
    endpoint->switchSuite(time, session(), suite);
}

void Pair::End::rekey(TimePoint time)
{
    endpoint->rekey(time, session());
}

void Pair::End::close(TimePoint time)
{
    endpoint->close(time, session());
}

void Pair::End::setPeers(TimePoint time, std::vector<Peer> peers)
{
    endpoint->setPeers(time, std::move(peers));
}

void Pair::End::setPolicy(TimePoint time, Policy newPolicy)
{
    endpoint->setPolicy(time, std::move(newPolicy));
}

std::optional<Transmit> Pair::End::pollTransmit()
{
    return endpoint->pollTransmit();
}

std::size_t Pair::End::switches() const
{
    std::size_t count = 0;
    for (const SwitchDone &done : all<SwitchDone>())
        count += done.failure == SwitchFailure::None;
    return count;
}

Pair::Pair(PairOptions options)
    : now(TimePoint(std::chrono::hours(1))), link(options.link, options.seed ^ 0x5eed), m_options(options),
      m_random(options.seed)
{
    for (const Side side : {Ground, Air}) {
        ends[side].identity = newIdentity(m_random);
        ends[side].policy = side == Ground ? m_options.ground : m_options.air;
        ends[side].port = side == Ground ? 14550 : 40000;
    }
    start(Ground);
    start(Air);
}

Pair::~Pair() = default;

Path Pair::pathOf(Side side) const
{
    Path path{LinkId{1}, {}};
    path.remote.ip[15] = static_cast<std::uint8_t>(side + 1);
    path.remote.port = ends[side].port;
    path.carrier = m_options.carrier;
    return path;
}

Config Pair::configOf(Side side) const
{
    const Side other = side == Ground ? Air : Ground;
    Config config;
    config.role = side == Ground ? Role::Station : Role::Agent;
    config.identity = ends[side].identity;
    config.peers.push_back(
        {ends[other].identity->publicKey, side == Ground ? "air" : "ground", PeerRole::Pilot, {}, m_options.presharedKey});
    config.policy = ends[side].policy;
    config.timing = m_options.timing;
    config.freshness = m_options.freshness;
    config.messageTraits = m_options.messageTraits;
    if (side == Air)
        config.announceTo.push_back(m_options.announceToAddress ? pathOf(Ground) : Path{LinkId{1}, {}, m_options.carrier});
    return config;
}

void Pair::start(Side side)
{
    ends[side].endpoint = std::make_unique<Endpoint>(configOf(side), m_random, ends[side].counters, nowAt(side));
}

void Pair::kill(Side side)
{
    ends[side].endpoint.reset();
}

void Pair::every(Duration period, std::function<void()> act)
{
    m_tasks.push_back({now + period, period, std::move(act)});
}

void Pair::pump()
{
    for (const Side side : {Ground, Air}) {
        End &end = ends[side];
        if (!end.endpoint)
            continue;
        while (const auto transmit = end.endpoint->pollTransmit()) {
            end.bytesOut += transmit->bytes.size();
            ++end.datagramsOut;
            Bytes bytes(transmit->bytes.begin(), transmit->bytes.end());
            link.send(now, {side, end.port, 0, std::move(bytes), transmit->to.remote.port});
        }
        while (auto event = end.endpoint->pollEvent())
            end.events.push_back(std::move(*event));
    }
}

bool Pair::run(Duration span, const std::function<bool()> &until)
{
    const TimePoint stop = now + span;
    pump();
    while (!(until && until())) {
        TimePoint due = link.next();
        for (const End &end : ends)
            due = end.endpoint ? std::min(due, end.clock.global(end.endpoint->nextDeadline())) : due;
        for (const Task &task : m_tasks)
            due = std::min(due, task.due);
        if (due > stop) {
            now = stop;
            return false;
        }
        now = std::max(now, due);
        if (link.next() <= now)
            arrive(link.take());
        for (const Side side : {Ground, Air}) {
            End &end = ends[side];
            if (end.endpoint && end.endpoint->nextDeadline() <= nowAt(side))
                end.endpoint->handleDeadline(nowAt(side));
        }
        for (std::size_t i = 0; i < m_tasks.size(); ++i) {
            if (m_tasks[i].due <= now) {
                m_tasks[i].due += m_tasks[i].period;
                m_tasks[i].act();
            }
        }
        pump();
    }
    return true;
}

void Pair::arrive(SentDatagram flight)
{
    const Side to = flight.from == Ground ? Air : Ground;
    End &end = ends[to];
    if (!end.endpoint) {
        if (flight.tag)
            dropped[flight.from].insert(flight.tag);
        return;
    }
    Path path = pathOf(flight.from);
    path.remote.port = flight.sourcePort;
    path.carrier = m_arrival;
    const bool inPlace = Endpoint::ownsFrame(flight.bytes);
    const auto delivery = inPlace ? end.endpoint->handleInlineFrame(nowAt(to), path, flight.bytes)
                                  : end.endpoint->handleDatagram(nowAt(to), path, flight.bytes);
    if (!delivery)
        return;
    ByteReader reader(delivery->frames);
    reader.bytes(m_options.makeFrame ? 10 : 1);
    const std::uint64_t number = reader.u64();
    ++end.delivered[number];
    end.freshness.emplace(number, delivery->freshness);
    end.arrived.emplace(number, now);
    end.epochs.push_back(static_cast<std::uint32_t>(delivery->epoch));
}

Bytes Pair::frameWith(std::uint64_t number, std::size_t size) const
{
    if (m_options.makeFrame)
        return m_options.makeFrame(number, size);
    Bytes frame(std::max<std::size_t>(size, 9));
    ByteWriter writer(frame);
    writer.u8(0xfd);
    writer.u64(number);
    return frame;
}

std::uint64_t Pair::sendFrame(Side from, std::size_t size)
{
    End &end = ends[from];
    if (!end.up())
        return 0;
    const std::uint64_t number = ++m_frames;
    const Bytes frame = frameWith(number, size);
    Bytes record(frame.size() + kMaxRecordOverhead);
    const SessionId session = end.session();
    auto sealed = end.endpoint->sealInline(nowAt(from), session, frame, record);
    if (!sealed && sealed.error() == SealError::NotInline)
        sealed = end.endpoint->seal(nowAt(from), session, frame, record);
    if (!sealed)
        return 0;
    record.resize(*sealed);
    sent[from].insert(number);
    sentAt[number] = now;
    if (!link.send(now, {from, end.port, number, std::move(record)}))
        dropped[from].insert(number);
    return number;
}

std::string Pair::accountFrom(Side side) const
{
    const End &receiver = ends[side == Ground ? Air : Ground];
    std::size_t missing = 0, twice = 0, unexpected = 0;
    for (const std::uint64_t number : sent[side]) {
        const auto found = receiver.delivered.find(number);
        const bool arrived = found != receiver.delivered.end();
        missing += !arrived && !dropped[side].contains(number);
        twice += arrived && found->second > 1;
    }
    for (const auto &[number, count] : receiver.delivered)
        unexpected += !sent[side].contains(number) || dropped[side].contains(number);
    if (missing + twice + unexpected == 0)
        return {};
    return "of " + std::to_string(sent[side].size()) + " sent: " + std::to_string(missing) + " missing, "
        + std::to_string(twice) + " twice, " + std::to_string(unexpected) + " that cannot be";
}

} // namespace skyseal::test
