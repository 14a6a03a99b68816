#include "core/engine/channel_driver.h"

#include <algorithm>

namespace skyseal::engine {

ChannelDriver::ChannelDriver(channel::Endpoint endpoint, LinkPool &links) : m_endpoint(std::move(endpoint)), m_links(links)
{
}

std::optional<channel::Delivery> ChannelDriver::receive(TimePoint now, const Path &from, MutableByteView datagram)
{
    const std::uint64_t begin = metrics::CycleClock::now();
    std::optional<channel::Delivery> delivery = m_endpoint.handleDatagram(now, from, datagram);
    const std::uint64_t end = metrics::CycleClock::now();
    m_wire.received += datagram.size();
    if (delivery) {
        const std::uint64_t taken = m_clock.between(begin, end);
        m_wire.receivedFrames += delivery->frames.size();
        m_meters[delivery->session].opened(delivery->suite, taken, delivery->frames.size(), m_slept);
        if (m_measuring)
            m_opening.record(taken);
    }
    m_slept = false;
    return delivery;
}

bool ChannelDriver::queue(TimePoint now, channel::SessionId session, ByteView frame)
{
    if (frame.size() > channel::kMaxRecordPayload)
        return false;
    Batch &batch = m_batches[session];
    if (batch.size + frame.size() > batch.frames.size())
        sealBatch(now, session, batch);
    std::copy(frame.begin(), frame.end(), batch.frames.begin() + static_cast<std::ptrdiff_t>(batch.size));
    batch.size += frame.size();
    return true;
}

void ChannelDriver::sealBatch(TimePoint now, channel::SessionId session, Batch &batch)
{
    if (batch.size == 0)
        return;
    const ByteView frames(batch.frames.data(), batch.size);
    batch.size = 0;
    const std::uint64_t begin = metrics::CycleClock::now();
    const auto size = m_endpoint.seal(now, session, frames, m_record);
    if (!size)
        return;
    const std::uint64_t end = metrics::CycleClock::now();
    const std::uint64_t taken = m_clock.between(begin, end);
    m_meters[session].sealed(m_sendSuites[session], taken);
    if (m_measuring)
        m_sealing.record(taken);
    m_wire.sent += *size;
    m_wire.sentFrames += frames.size();
    m_links.send(m_endpoint.recordPath(session), ByteView(m_record).first(*size));
}

void ChannelDriver::transmit()
{
    while (const auto out = m_endpoint.pollTransmit()) {
        m_wire.sent += out->bytes.size();
        m_links.send(out->to, out->bytes);
    }
}

void ChannelDriver::flush(TimePoint now)
{
    for (auto &[session, batch] : m_batches)
        sealBatch(now, session, batch);
    transmit();
    m_slept = true; // the thread goes to sleep after this
}

std::optional<channel::Event> ChannelDriver::pollEvent()
{
    std::optional<channel::Event> event = m_endpoint.pollEvent();
    if (!event)
        return event;
    if (const auto *up = std::get_if<channel::SessionUp>(&*event))
        m_sendSuites[up->session] = up->suite;
    if (const auto *done = std::get_if<channel::SwitchDone>(&*event); done && done->failure == channel::SwitchFailure::None)
        m_sendSuites[done->session] = done->to;
    if (const auto *down = std::get_if<channel::SessionDown>(&*event)) {
        m_endedRx += down->stats.rx;
        m_endedTx += down->stats.tx;
        m_endedPeerRx += down->stats.peerRx;
        m_batches.erase(down->session);
        m_meters.erase(down->session);
        m_sendSuites.erase(down->session);
    }
    return event;
}

void ChannelDriver::roll(TimePoint now)
{
    for (auto &[session, meter] : m_meters)
        meter.roll(now);
}

SuiteCost ChannelDriver::cost(channel::SessionId session) const
{
    const auto found = m_meters.find(session);
    return found == m_meters.end() ? SuiteCost{} : found->second.cost();
}

ChannelTotals ChannelDriver::totals() const
{
    ChannelTotals out;
    out.rx = m_endedRx;
    out.tx = m_endedTx;
    out.peerRx = m_endedPeerRx;
    out.rx += m_endpoint.strays();
    out.wire = m_wire;
    TimePoint heard = TimePoint::min();
    for (const channel::SessionId session : m_endpoint.sessions()) {
        if (const auto stats = m_endpoint.stats(session)) {
            out.rx += stats->rx;
            out.tx += stats->tx;
            out.peerRx += stats->peerRx;
            ++out.sessions;
        }
        const auto info = m_endpoint.sessionInfo(session);
        if (info && info->lastReceived >= heard) {
            heard = info->lastReceived;
            out.up = true;
            out.suite = info->suite;
            out.epoch = static_cast<std::uint32_t>(info->epoch);
            out.cost = cost(session);
            if (const auto stats = m_endpoint.stats(session))
                out.roundTrip = stats->roundTrip;
        }
    }
    return out;
}

} // namespace skyseal::engine
