// Opens the records and the frames sealed in place of one session, with the keys of its live epochs, and counts the refused
// ones (PROTOCOL.md, sections 6 and 12). Does not know the state of the session: the caller decides on the consequences.
#pragma once

#include "core/base/path.h"
#include "core/base/result.h"
#include "core/channel/epochs.h"
#include "core/channel/forgery_counter.h"
#include "core/channel/inline_frame.h"
#include "core/channel/record.h"

namespace skyseal::channel {

/// Why a record was refused.
enum class RecordFault : std::uint8_t {
    Replayed,
    Forged,
    Malformed, ///< a frame sealed in place under a suite that has no such framing
    Cloned     ///< authentic, but its counter was used by another authentic record: see recent_tags.h
};

struct OpenRecord
{
    LiveEpoch &epoch;
    std::uint32_t counter = 0;
    MutableByteView plaintext; ///< within the received bytes
};

class RecordReceiver
{
public:
    /// `epochs` must outlive this object. `direction`: of the received records.
    RecordReceiver(Epochs &epochs, Direction direction, TimePoint now)
        : m_epochs(epochs), m_direction(direction), m_forgeries(now)
    {}

    /// Opens a record in place. The replay window is not marked yet.
    Result<OpenRecord, RecordFault> open(const RecordHeader &header, Carrier carrier, MutableByteView datagram);
    /// The same for a frame that was sealed in place.
    Result<OpenRecord, RecordFault> openInline(const InlineFrame &frame, Carrier carrier);

    /// Refused records since the last alarm.
    ForgeryCounter &forgeries() { return m_forgeries; }
    const ForgeryCounter &forgeries() const { return m_forgeries; }

private:
    tl::unexpected<RecordFault> refuse(RecordFault fault, LiveEpoch &epoch);
    tl::unexpected<RecordFault> refuseEpoch(unsigned ahead);

    Epochs &m_epochs;
    Direction m_direction;
    ForgeryCounter m_forgeries;
};

} // namespace skyseal::channel
