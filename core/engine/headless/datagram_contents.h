// Reads the parts of a datagram that are visible without keys: the number of sealed units and the headers of MAVLink frames.
// The report of a relay counts its drops by it, so that tests can compare the counters of both ends with independent counts.
// Follows PROTOCOL.md 2 (records) and 12 (frames sealed in place), and the packet formats of the MAVLink guide.
#pragma once

#include "core/base/bytes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace skyseal::engine {

struct DatagramContents
{
    /// Header of a MAVLink frame, clear or sealed in place.
    struct Frame
    {
        std::uint8_t system = 0, component = 0, sequence = 0;
        bool sealedInPlace = false;
        bool operator==(const Frame &) const = default;
    };

    /// Connection id of a record; none in other datagrams, handshakes included.
    std::optional<std::uint16_t> connection;
    /// The two low bits of the epoch, and the counters of the record or of the frames that are sealed in place.
    std::optional<std::uint8_t> epoch;
    std::vector<std::uint32_t> counters;
    std::vector<Frame> frames;

    /// Units that the receiver's session counts: one for a record, or one for each frame that is sealed in place.
    std::uint64_t sealedUnits() const { return counters.size(); }
    std::uint64_t clearFrames() const;
};

/// Follows the length fields from frame to frame and stops at the first byte that does not begin a frame.
DatagramContents contentsOf(ByteView datagram);

} // namespace skyseal::engine
