// The part of a session that seals frames in place and opens such frames. It shares counters, window and epochs with the
// records, and nothing else: the keys are others.
#include "core/channel/session.h"

namespace skyseal::channel {

namespace {

/// Routers that take a frame out of a datagram or a stream must not change what is authenticated, and datagrams are the only
/// carrier in which frames travel as they are.
constexpr Carrier kCarrier = Carrier::Datagram;

} // namespace

Framing Session::agreedFraming() const
{
    return inlineAllowed() && inlineWanted(m_around.offer, m_setup.peerOffer) ? Framing::Inline : Framing::Sealed;
}

Framing Session::framing() const
{
    // A peer that was not heard yet cannot find the session by our address, and an agent must be shown first that we are no
    // replay: both take a record.
    return m_confirmed && m_epochs.current().inlineWriter ? agreedFraming() : Framing::Sealed;
}

Sealed Session::sealInline(TimePoint now, ByteView frame, MutableByteView out)
{
    if (framing() != Framing::Inline)
        return SealError::NotInline;
    const auto sealable = SealableFrame::read(frame, *m_around.facts);
    if (!sealable)
        return SealError::NotInline;
    if (out.size() < sealable->sealedSize())
        return SealError::NoRoom;
    LiveEpoch &epoch = m_epochs.current();
    if (epoch.sent >= m_around.timing.hardStopRecords) {
        m_finished = DownReason::Exhausted;
        return SealError::Exhausted;
    }
    const InlinePlace place{static_cast<std::uint8_t>(epoch.number), epoch.sent++, ourDirection(), kCarrier};
    if (!sealable->seal(place, *epoch.inlineWriter, out))
        return SealError::NoRoom;
    ++epoch.tx.records;
    epoch.tx.sealedBytes += sealable->sealedSize();
    m_lastSent = now;
    return sealable->sealedSize();
}

Session::Opened Session::openInline(TimePoint now, const InlineFrame &frame, std::optional<Delivery> &delivery)
{
    if (!inlineAllowed()) {
        countMalformed();
        return {false, true};
    }
    LiveEpoch *epoch = m_epochs.byLowByte(frame.epochByte());
    if (!epoch) {
        // No keys: either of an epoch that is over, or of one that nobody has agreed on.
        const auto ahead = static_cast<std::uint8_t>(frame.epochByte() - static_cast<std::uint32_t>(currentEpoch()));
        return refuse(now, ahead == 1 ? &ReceiveCounters::forged : &ReceiveCounters::replayed, m_epochs.current());
    }
    if (!epoch->inlineReader) { // An epoch of a suite that never seals in place.
        ++epoch->rx.malformed;
        return {false, true};
    }
    if (!epoch->window.fresh(frame.counter()))
        return refuse(now, &ReceiveCounters::replayed, *epoch);
    const auto plain = frame.open(opposite(ourDirection()), kCarrier, *epoch->inlineReader);
    if (!plain)
        return refuse(now, &ReceiveCounters::forged, *epoch);
    RecordHeader header;
    header.counter = frame.counter();
    // As if it came from where the session's records come from: only those move the address.
    return opened(now, m_setup.path, header, *epoch, *plain, delivery);
}

} // namespace skyseal::channel
