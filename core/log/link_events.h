// The cipher suites of the links of a recording. The frames of a .tlog are in clear and say nothing about them, so the station
// notes them in a file beside it, NAME.tlog.events: the .tlog itself stays a plain one, with no entry that nobody sent, and
// other programs read it as before. One event a line, appended as it occurs, so that a crash cuts at most the last line:
//
//     1700000000000000 sealed chacha20-poly1305 air-1
//     1700000031000000 switched aes-256-gcm air-1
//     1700000052000000 plain none 2
//
// microseconds since 1970-01-01 UTC, by the clock of the .tlog; what happened; the suite, by its name in options; the peer, up
// to the end of the line, or the system ID of a vehicle without one. A line that begins with # is a comment.
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::tlog {

struct LinkEvent
{
    enum class Kind : std::uint8_t {
        Sealed,   ///< a sealed link came up with this suite, or was up when the recording began
        Switched, ///< from another suite to this one
        Plain     ///< a vehicle was heard in plain MAVLink, for the first time or after it was heard sealed
    };

    static constexpr std::size_t kLongestSuite = 40, kLongestPeer = 100; ///< bytes

    Kind kind{};
    WallTime time{};
    std::string suite; ///< letters, digits and hyphens; need not be one that this build knows
    std::string peer;  ///< printable; may be empty
    bool operator==(const LinkEvent &) const = default;
};

struct LinkEvents
{
    /// Limits of what is read, whatever the file contains.
    static constexpr std::size_t kMostBytes = 1u << 20, kMost = 4000;

    std::vector<LinkEvent> events; ///< in the order of the file
    std::uint64_t unreadable = 0;  ///< lines that are no event; what is beyond the limits counts as one
};

/// The line of an event, with its end. Unprintable characters of the peer's name are replaced, and a long name is shortened.
std::string lineOf(const LinkEvent &event);

/// The event of a line without its end; nullopt if it is none.
std::optional<LinkEvent> linkEventOf(std::string_view line);

/// Reads `input` to its end, or to the limits.
LinkEvents readLinkEvents(std::istream &input);

/// The path of the file beside a recording.
std::string linkEventsFile(const std::string &recording);

/// Reads the file beside a recording: no events if there is none, one unreadable line if it cannot be opened.
LinkEvents linkEventsOf(const std::string &recording);

} // namespace skyseal::tlog
