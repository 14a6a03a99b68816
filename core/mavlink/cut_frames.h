// Frames that begin in one datagram and end in a later one of the same sender. Transparent bridges from a serial line to UDP
// (telemetry modems, LTE routers, Wi-Fi modules) fill datagrams without regard to frames, so that the datagrams of one sender
// are one stream of bytes.
//
// Anybody may send datagrams, so the memory is fixed, and bytes that do not end in a frame are kept less and less often. Runs
// on the thread of its owner; no I/O and no allocation.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/mavlink/frame.h"

#include <algorithm>
#include <array>
#include <span>

namespace skyseal::mavlink {

class CutFrames
{
public:
    /// The longest beginning of a frame that is not complete.
    static constexpr std::size_t kLongest = kMaxFrameLength - 1;
    static constexpr std::size_t kSenders = 32;
    /// A sender one of whose cut frames was completed within this time keeps its place.
    static constexpr Duration kEstablishedFor = std::chrono::seconds(10);

    /// The state of one sender.
    struct Sender
    {
        Path from;
        std::uint64_t hash = 0; ///< of `from`
        TimePoint used{};       ///< time of its newest cut frame; TimePoint{} if the place is free
        TimePoint completed{};  ///< time at which a cut frame was last completed
        unsigned failures = 0;  ///< since then
        unsigned passedOver = 0;
        std::size_t kept = 0; ///< bytes of the beginning of its frame

        bool isEstablished(TimePoint now) const { return completed != TimePoint{} && now - completed < kEstablishedFor; }
    };

    /// The sender, if the beginning of a frame is kept for it; valid until the next call of another function.
    Sender *find(const Path &from) { return m_kept == 0 ? nullptr : findKept(from); }
    /// What is kept for the sender.
    ByteView begin(const Sender &sender) { return {bytesOf(sender).data(), sender.kept}; }
    /// Keeps the incomplete frame at the end of a datagram. Returns false if it is not kept: there is no place for the sender,
    /// what was kept for it before was no frame, or the frame has a form that is not read.
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

    using Bytes = std::array<std::uint8_t, kLongest>;

    std::span<Sender, kWays> placesOf(std::uint64_t hash);
    Bytes &bytesOf(const Sender &sender) { return m_bytes[static_cast<std::size_t>(&sender - m_senders.data())]; }
    Sender *findKept(const Path &from);
    Sender *place(TimePoint now, const Path &from);
    void drop(Sender &sender);

    std::array<Sender, kSenders> m_senders;
    std::array<Bytes, kSenders> m_bytes; ///< apart, so that the search for a place passes over few cache lines
    std::size_t m_kept = 0;              ///< senders of which a beginning is kept
};

} // namespace skyseal::mavlink
