// What a datagram shows to somebody without keys: how many sealed units are in it, and whose MAVLink frames stand in the
// clear. The relay counts its drops by it, so that both ends' books can be checked against an account that neither of them
// made. Follows PROTOCOL.md 2 (records) and 12 (frames sealed in place), and the MAVLink guide's packet formats.
#pragma once

#include "core/base/bytes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace skyseal::link {

struct DatagramContents
{
    /// Header of a MAVLink frame, clear or sealed in place.
    struct Frame
    {
        std::uint8_t system = 0, component = 0, sequence = 0;
        bool sealedInPlace = false;
        bool operator==(const Frame &) const = default;
    };

    /// Of a record: the receiver's name for the session. Nothing for all else, handshakes included.
    std::optional<std::uint16_t> connection;
    /// The two low bits of the epoch that it was sealed under, and the counters of the record or of the frames in place.
    std::optional<std::uint8_t> epoch;
    std::vector<std::uint32_t> counters;
    std::vector<Frame> frames;

    /// What the receiver's session counts one by one: a record, or each frame that is sealed in place.
    std::uint64_t sealedUnits() const { return counters.size(); }
    std::uint64_t clearFrames() const;
};

/// Frames are walked by the lengths that they give; what comes behind a byte that begins none is not looked at.
DatagramContents contentsOf(ByteView datagram);

} // namespace skyseal::link
