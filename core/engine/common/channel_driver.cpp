#include "core/engine/common/channel_driver.h"

#include "core/channel/endpoint.h"
#include "core/channel/record.h"
#include "core/engine/common/urgency.h"
#include "core/mavlink/frame.h"

#include <algorithm>
#include <utility>

namespace skyseal::engine {

namespace {

/// Bytes of frames that are coalesced into one record. On a serial line, as many as one code byte of COBS covers: 45 ms of a
/// 57,600-baud radio, so that an urgent frame never waits long behind them and a damaged byte does not cost more.
constexpr std::size_t kSerialRoom = 254 - channel::kSingleHeaderLength - channel::kMacLength;
/// In a TUNNEL, as many as its payload holds; a suite with padding holds fewer.
constexpr std::size_t kTunnelRoom = channel::kTunnelPayload - channel::kRecordHeaderLength - channel::kMacLength;

void add(ChannelTotals &sum, const channel::SessionStats &session)
{
    sum.rx += session.rx;
    sum.tx += session.tx;
    sum.peerRx += session.peerRx;
    sum.peerFrames += session.peerFrames;
}

} // namespace

ChannelDriver::ChannelDriver(channel::Endpoint endpoint, LinkPool &links)
    : m_endpoint(std::make_unique<channel::Endpoint>(std::move(endpoint))), m_links(links)
{}

ChannelDriver::~ChannelDriver() = default;

void ChannelDriver::Batch::add(TimePoint now, ByteView bytes)
{
    if (size == 0)
        since = now;
    std::copy(bytes.begin(), bytes.end(), frames.begin() + static_cast<std::ptrdiff_t>(size));
    size += bytes.size();
}

std::optional<channel::Delivery> ChannelDriver::receive(TimePoint now, const Path &from, MutableByteView datagram)
{
    const std::uint64_t begin = m_costs.begin();
    return taken(begin, datagram.size(), m_endpoint->handleDatagram(now, from, datagram));
}

std::optional<channel::Delivery> ChannelDriver::receiveInline(TimePoint now, const Path &from, MutableByteView frame)
{
    const std::uint64_t begin = m_costs.begin();
    return taken(begin, frame.size(), m_endpoint->handleInlineFrame(now, from, frame));
}

std::optional<channel::Delivery> ChannelDriver::taken(std::uint64_t begin, std::size_t bytes,
                                                      std::optional<channel::Delivery> delivery)
{
    const std::uint64_t end = metrics::CycleClock::now();
    m_kept.wire.received += bytes;
    if (delivery) {
        m_kept.wire.receivedFrames += delivery->frames.size();
        m_costs.opened(begin, end, *delivery);
    }
    m_costs.wokeUp();
    return delivery;
}

bool ChannelDriver::queue(TimePoint now, channel::SessionId session, ByteView frame)
{
    if (frame.size() > channel::kMaxRecordPayload)
        return false;
    Batch &batch = m_batches[session];
    if (m_endpoint->framing(session) == channel::Framing::Inline && queueInline(now, session, frame, batch))
        return true;
    if (batch.sealedInPlace || !batch.holds(frame.size(), roomOf(m_endpoint->recordPath(session), session)))
        sealBatch(now, session, batch);
    batch.urgent = batch.urgent || isUrgent(frame);
    batch.add(now, frame);
    return true;
}

std::size_t ChannelDriver::roomOf(const Path &path, channel::SessionId session)
{
    switch (path.carrier) {
    case Carrier::Datagram: break;
    case Carrier::Tunnel:
        return crypto::suiteInfo(m_sendSuites[session]).plaintextRoom(kTunnelRoom) - m_endpoint->stampLength();
    case Carrier::Serial: return kSerialRoom - m_endpoint->stampLength();
    }
    return channel::kMaxRecordPayload;
}

bool ChannelDriver::mayWait(TimePoint now, const Path &path, Batch &batch) const
{
    if (batch.path != path) {
        batch.path = path;
        batch.slow = m_links.isSlow(path);
    }
    return batch.slow && !batch.urgent && !batch.sealedInPlace && now < batch.since + kCoalesceDelay;
}

/// Returns false if this frame has to be sent in a record.
bool ChannelDriver::queueInline(TimePoint now, channel::SessionId session, ByteView frame, Batch &batch)
{
    if (frame[0] != mavlink::kMagic2 || frame.size() < 3 || frame[2] != 0)
        return false;
    if (!batch.sealedInPlace) // the frames before it are sealed first, since counters increase
        sealBatch(now, session, batch);
    transmit();
    const std::uint64_t begin = m_costs.begin();
    const auto size = m_endpoint->sealInline(now, session, frame, m_record);
    const std::uint64_t end = metrics::CycleClock::now();
    if (!size)
        return false;
    m_costs.sealed(begin, end, session, m_sendSuites[session]);
    m_kept.wire.sentFrames += frame.size();
    if (!batch.holds(*size, batch.frames.size()))
        sealBatch(now, session, batch);
    batch.sealedInPlace = true;
    batch.add(now, ByteView(m_record).first(*size));
    return true;
}

void ChannelDriver::sealBatch(TimePoint now, channel::SessionId session, Batch &batch)
{
    if (batch.size == 0)
        return;
    if (batch.sealedInPlace)
        return sendInPlace(session, batch);
    const ByteView frames(batch.frames.data(), batch.size);
    batch.size = 0;
    batch.urgent = false;
    transmit();
    const std::uint64_t begin = m_costs.begin();
    const auto size = m_endpoint->seal(now, session, frames, m_record);
    if (!size)
        return;
    const std::uint64_t end = metrics::CycleClock::now();
    m_costs.sealed(begin, end, session, m_sendSuites[session]);
    m_kept.wire.sent += *size;
    m_kept.wire.sentFrames += frames.size();
    m_links.send(m_endpoint->recordPath(session), ByteView(m_record).first(*size));
}

/// Call before anything else is sealed: its counter is greater than those of the waiting records, which would arrive late.
/// Frames that were sealed in place before these records go first, those of all sessions.
void ChannelDriver::transmit()
{
    if (!m_endpoint->hasTransmit())
        return;
    for (auto &[session, batch] : m_batches) {
        if (batch.sealedInPlace)
            sendInPlace(session, batch);
    }
    while (const auto out = m_endpoint->pollTransmit()) {
        m_kept.wire.sent += out->bytes.size();
        m_links.send(out->to, out->bytes);
    }
}

void ChannelDriver::sendInPlace(channel::SessionId session, Batch &batch)
{
    const ByteView frames(batch.frames.data(), std::exchange(batch.size, 0));
    batch.sealedInPlace = false;
    batch.urgent = false;
    m_kept.wire.sent += frames.size();
    m_links.send(m_endpoint->recordPath(session), frames);
}

void ChannelDriver::flush(TimePoint now)
{
    m_flushDue = kNever;
    for (auto &[session, batch] : m_batches) {
        if (batch.size > 0 && mayWait(now, m_endpoint->recordPath(session), batch))
            m_flushDue = std::min(m_flushDue, batch.since + kCoalesceDelay);
        else
            sealBatch(now, session, batch);
    }
    transmit();
    m_costs.sleeps();
}

void ChannelDriver::flushAll(TimePoint now)
{
    m_flushDue = kNever;
    for (auto &[session, batch] : m_batches)
        sealBatch(now, session, batch);
    transmit();
    m_costs.sleeps();
}

std::vector<ChannelDriver::Goodbye> ChannelDriver::closeAll(TimePoint now)
{
    flushAll(now);
    for (const channel::SessionId session : m_endpoint->sessions())
        m_endpoint->close(now, session);
    std::vector<Goodbye> out;
    while (const auto goodbye = m_endpoint->pollTransmit()) {
        out.push_back({goodbye->to, Bytes(goodbye->bytes.begin(), goodbye->bytes.end())});
        m_kept.wire.sent += goodbye->bytes.size();
        m_links.send(goodbye->to, goodbye->bytes);
    }
    return out;
}

std::optional<channel::Event> ChannelDriver::pollEvent(std::optional<channel::SessionId> speaking)
{
    std::optional<channel::Event> event = m_left ? std::exchange(m_left, std::nullopt) : m_endpoint->pollEvent();
    if (!event)
        return event;
    if (const auto *down = std::get_if<channel::SessionDown>(&*event); down && down->session == speaking) {
        m_left = std::move(event);
        return std::nullopt;
    }
    if (const auto *up = std::get_if<channel::SessionUp>(&*event))
        m_sendSuites[up->session] = up->suite;
    if (const auto *done = std::get_if<channel::SwitchDone>(&*event); done && done->failure == channel::SwitchFailure::None)
        m_sendSuites[done->session] = done->to;
    if (const auto *down = std::get_if<channel::SessionDown>(&*event)) {
        add(m_kept, down->stats);
        m_batches.erase(down->session);
        m_costs.forget(down->session);
        m_sendSuites.erase(down->session);
    }
    return event;
}

void ChannelDriver::roll(TimePoint now)
{
    m_costs.roll(now);
    // Including sessions that carry only their own reports.
    for (const channel::SessionId session : m_endpoint->sessions()) {
        const auto info = m_endpoint->sessionInfo(session);
        if (info && now < info->lastReceived + std::chrono::seconds(2))
            m_links.noteUse(info->path);
    }
}

void ChannelDriver::setMeasuring(bool measuring)
{
    m_costs.setMeasuring(measuring);
}

ChannelTotals ChannelDriver::totals() const
{
    ChannelTotals out = m_kept;
    out.unmatched = m_endpoint->unmatched();
    out.rx += out.unmatched;
    TimePoint heard = TimePoint::min();
    for (const channel::SessionId session : m_endpoint->sessions()) {
        if (const auto stats = m_endpoint->stats(session)) {
            add(out, *stats);
            ++out.sessions;
        }
        const auto info = m_endpoint->sessionInfo(session);
        if (info && info->lastReceived >= heard) {
            heard = info->lastReceived;
            out.up = true;
            out.suite = info->suite;
            out.epoch = static_cast<std::uint32_t>(info->epoch);
            out.framing = info->framing;
            out.cost = m_costs.of(session);
            if (const auto stats = m_endpoint->stats(session))
                out.roundTrip = stats->roundTrip;
        }
    }
    return out;
}

} // namespace skyseal::engine
