#include "core/engine/common/ingress.h"

#include "core/channel/wire_format.h"
#include "core/engine/common/sealed_in_place.h"

namespace skyseal::engine {

void Ingress::setRules(LinkId id, const IngressRules &rules)
{
    if (const auto found = m_links.find(id); found != m_links.end())
        found->second.rules = rules;
}

void Ingress::setSink(LinkId id, IngressSink &sink)
{
    if (const auto found = m_links.find(id); found != m_links.end())
        found->second.sink = &sink;
}

void Ingress::forget(const Path &stream)
{
    m_frames.forget(stream);
    m_reader.forget(stream);
}

void Ingress::take(const link::Link &link, const link::ReceivedBlock &block)
{
    const auto found = m_links.find(link.id());
    if (found == m_links.end())
        return;
    if (found->second.rules.isStream)
        takeStream(found->second, link, block);
    else
        takeDatagram(found->second, link, block);
}

void Ingress::takeStream(const Registered &to, const link::Link &link, const link::ReceivedBlock &block)
{
    const IngressRules &rules = to.rules; // a sink may change them, so each is read at its use
    if (rules.takesCobs)
        m_reader.takeCobs(
            block, [&](ByteView message) { return to.sink->namesSession(message); },
            [&](const link::ReceivedBlock &message) {
                return !to.sink->takePairing(link, message) && to.sink->takeRecord(link, message);
            });
    if (rules.clear == ClearScan::Never
        || (rules.clear == ClearScan::UnlessCobs && rules.takesCobs && m_reader.isCobs(block.path, block.time)))
        return;
    m_frames.takeStream(block.path, block.bytes, [&](const mavlink::ScanItem &item) {
        if (rules.takesCobs && item.frame)
            m_reader.noteMavlink(block.path);
        else if (rules.takesCobs && mavlink::isDamagedFrame(item) && !m_reader.speaksMavlink(block.path))
            return; // an incomplete COBS frame can resemble a damaged MAVLink frame
        if (!takeTunnel(to, link, block, item))
            to.sink->takeClear(link, block, item);
    });
}

void Ingress::takeDatagram(const Registered &to, const link::Link &link, const link::ReceivedBlock &block)
{
    const IngressRules &rules = to.rules;
    // The middle of a cut clear frame can resemble a message of the channel.
    const bool continues = rules.clear != ClearScan::Never && m_frames.isCut(block.path);
    if (rules.takesDatagrams && !continues && takeMessage(*to.sink, link, block))
        return;
    if (rules.clear == ClearScan::Never) {
        const bool clear = !block.bytes.empty() && mavlink::isMagic(block.bytes[0]);
        return to.sink->takeUnusable(link, clear ? Unusable::Clear : Unusable::Garbage);
    }
    bool whole = false, damaged = false;
    const bool isPart = m_frames.takeDatagram(block.time, block.path, block.bytes, [&](const mavlink::ScanItem &item) {
        const bool inPlace = isSealedInPlace(item);
        whole = whole || inPlace || mavlink::isWholeFrame(item);
        damaged = damaged || item.fault != mavlink::FrameFault::Garbage;
        if (inPlace && rules.takesDatagrams)
            to.sink->takeSealedInPlace(link, {block.path, block.bytes.subspan(item.offset, item.bytes.size()), block.time});
        else if (!takeTunnel(to, link, block, item))
            to.sink->takeClear(link, block, item);
    });
    // Anybody can send the beginning of a frame from the address of an agent, so that what may be a record is one all the same.
    if (continues && rules.sealed && rules.takesDatagrams && takeMessage(*to.sink, link, block))
        return;
    if (!whole)
        to.sink->takeUnusable(link, damaged || isPart ? Unusable::Damaged : Unusable::Garbage);
}

/// Returns false for a frame that does not belong to the channel.
bool Ingress::takeTunnel(const Registered &to, const link::Link &link, const link::ReceivedBlock &block,
                         const mavlink::ScanItem &item)
{
    if (!to.rules.takesTunnel)
        return false;
    if (!CarrierReader::isTunnel(item))
        return to.rules.dropsNodeHeartbeats && item.frame && m_reader.isAgentsHeartbeat(block.path, *item.frame);
    const auto message = m_reader.takeTunnel(block.time, block.path, *item.frame, m_carriers.node());
    if (message && !takeMessage(*to.sink, link, *message))
        to.sink->takeUnusable(link, Unusable::Message);
    return true;
}

/// Returns false if the message does not belong to the channel.
bool Ingress::takeMessage(IngressSink &sink, const link::Link &link, const link::ReceivedBlock &message)
{
    if (sink.takePairing(link, message))
        return true;
    if (message.bytes.empty() || !channel::isOurs(message.bytes[0]))
        return false;
    sink.takeRecord(link, message);
    return true;
}

} // namespace skyseal::engine
