// Frames that begin in one datagram and end in a later one of the same sender. Transparent bridges from a serial line to UDP
// (telemetry modems, LTE routers, Wi-Fi modules) fill datagrams without regard to frames, so that the datagrams of one sender
// are one stream of bytes.
//
// Anybody may send datagrams, so the memory is fixed, and bytes that do not end in a frame are kept less and less often. Runs on
// the thread of its owner; no I/O and no allocation.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/mavlink/frame.h"

#include <algorithm>
#include <array>

namespace skyseal::mavlink {

class CutFrames
{
public:
    /// The longest beginning of a frame that is not complete.
    static constexpr std::size_t kLongest = kMaxFrameLength - 1;
    static constexpr std::size_t kSenders = 64;
    /// A sender one of whose cut frames was completed within this time keeps its place.
    static constexpr Duration kEstablishedFor = std::chrono::seconds(10);

    /// The state of one sender.
    class Sender
    {
    public:
        /// The beginning of its frame; empty if none is kept.
        ByteView begin() const { return {m_bytes.data(), m_size}; }

    private:
        friend class CutFrames;

        bool isEstablished(TimePoint now) const { return m_completed != TimePoint{} && now - m_completed < kEstablishedFor; }

        Path m_from;
        TimePoint m_used{};      ///< time of its newest cut frame; TimePoint{} if the place is free
        TimePoint m_completed{}; ///< time at which a cut frame was last completed
        unsigned m_failures = 0; ///< since then
        unsigned m_passedOver = 0;
        std::size_t m_size = 0;
        std::array<std::uint8_t, kLongest> m_bytes{};
    };

    /// The sender, if the beginning of a frame is kept for it; valid until the next call of another function.
    Sender *find(const Path &from) { return m_kept == 0 ? nullptr : findKept(from); }
    /// Keeps the incomplete frame at the end of a datagram. Returns false if it is not kept: there is no place for the sender, or
    /// what was kept for it before was no frame.
    bool keep(TimePoint now, const Path &from, ByteView begin);
    /// The frame continues without an end in the next datagram: `begin` is what there is of it now.
    void extend(TimePoint now, Sender &sender, ByteView begin);
    /// The frame was completed, or turned out to be none.
    void completed(TimePoint now, Sender &sender);
    void failed(Sender &sender);
    /// Drops what is kept for the sender.
    void forget(const Path &from);

private:
    static constexpr std::size_t kWays = 4; ///< places among which a sender chooses

    Sender *findKept(const Path &from);
    std::array<Sender, kWays> &placesOf(const Path &from);
    Sender *place(TimePoint now, const Path &from);
    void drop(Sender &sender);

    std::array<std::array<Sender, kWays>, kSenders / kWays> m_places;
    std::size_t m_kept = 0; ///< senders of which a beginning is kept
};

} // namespace skyseal::mavlink
