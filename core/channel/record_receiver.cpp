#include "core/channel/record_receiver.h"

namespace skyseal::channel {

Result<OpenRecord, RecordFault> RecordReceiver::open(const RecordHeader &header, Carrier carrier, MutableByteView datagram)
{
    LiveEpoch *epoch = m_epochs.byBits(header.epochBits);
    if (!epoch)
        return refuseEpoch((header.epochBits - static_cast<unsigned>(m_epochs.current().number)) & 3);
    const std::uint32_t tagEnd = RecentTags::endOf(datagram);
    const bool fresh = epoch->window.fresh(header.counter);
    if (!fresh && !epoch->tags.contradicts(header.counter, tagEnd))
        return refuse(RecordFault::Replayed, *epoch);

    const AssociatedData aad(datagram.first(header.length()), epoch->suite, m_direction, carrier);
    const auto plaintext = epoch->reader->open(nonceOf(header.counter), aad.view(), datagram.subspan(header.length()));
    if (!fresh)
        return refuse(plaintext ? RecordFault::Cloned : RecordFault::Replayed, *epoch);
    if (!plaintext)
        return refuse(RecordFault::Forged, *epoch);
    epoch->tags.note(header.counter, tagEnd);
    return OpenRecord{*epoch, header.counter, *plaintext};
}

Result<OpenRecord, RecordFault> RecordReceiver::openInline(const InlineFrame &frame, Carrier carrier)
{
    LiveEpoch *epoch = m_epochs.byLowByte(frame.epochByte());
    if (!epoch)
        return refuseEpoch(
            static_cast<std::uint8_t>(frame.epochByte() - static_cast<std::uint32_t>(m_epochs.current().number)));
    if (!epoch->inlineReader)
        return refuse(RecordFault::Malformed, *epoch);
    if (!epoch->window.fresh(frame.counter()))
        return refuse(RecordFault::Replayed, *epoch);
    const auto plain = frame.open(m_direction, carrier, *epoch->inlineReader);
    if (!plain)
        return refuse(RecordFault::Forged, *epoch);
    return OpenRecord{*epoch, frame.counter(), *plain};
}

tl::unexpected<RecordFault> RecordReceiver::refuse(RecordFault fault, LiveEpoch &epoch)
{
    switch (fault) {
    case RecordFault::Replayed:
    case RecordFault::Cloned:
        ++epoch.rx.replayed;
        m_forgeries.addReplayed();
        break;
    case RecordFault::Forged:
        ++epoch.rx.forged;
        m_forgeries.addForged();
        break;
    case RecordFault::Malformed: ++epoch.rx.malformed; break;
    }
    return tl::unexpected(fault);
}

/// There are no keys for the epoch: it is over, or (one ahead of the current) both ends have not agreed on it.
tl::unexpected<RecordFault> RecordReceiver::refuseEpoch(unsigned ahead)
{
    return refuse(ahead == 1 ? RecordFault::Forged : RecordFault::Replayed, m_epochs.current());
}

} // namespace skyseal::channel
