// Report of a relay (core/link/impairer.h): the contents of the datagrams that it dropped or duplicated, and the JSON
// lines of skyseal-cli impair. Names and shapes are part of the program's interface.
#pragma once

#include "core/engine/headless/datagram_contents.h"
#include "core/link/impairer.h"

#include <array>
#include <string>

namespace skyseal::engine {

/// Contents of the datagrams of one direction that were dropped or duplicated: sealed units (records and frames sealed in
/// place, without handshakes) and clear MAVLink frames. A receiver must miss exactly the dropped ones.
struct RelayLosses
{
    std::uint64_t droppedDatagrams = 0; ///< handshakes included
    std::uint64_t droppedRecords = 0, droppedFrames = 0;
    std::uint64_t duplicatedRecords = 0, duplicatedFrames = 0;

    void add(const impair::Treatment &verdict, const DatagramContents &contents);
};

/// Indexed by link::Impairer::Direction.
using RelayAccount = std::array<RelayLosses, 2>;

/// One JSON object: {"event":EVENT,"t":…,"forward":{…},"backward":{…}}, t in seconds since the start.
std::string statsJson(const char *event, const link::Impairer &impairer, const RelayAccount &account, Duration sinceStart);
/// {"event":"drop","t":…,"direction":"forward"|"backward","sequence":…,"bytes":…,"reason":"loss"|"queue",
/// "so_far":{"datagrams":…,"records":…,"frames":…}}, the last of which are dropped in this direction, this one included.
std::string dropJson(link::Impairer::Direction direction, Duration sinceStart, const impair::Treatment &verdict,
                     const RelayLosses &soFar);
/// {"event":"in","t":…,"direction":…,"sequence":…,"bytes":…,"fate":"passed"|"lost"|"queue_full","duplicated":…,
/// "held_back":…,"corrupted":…,"counters":[…] (sealed units),"connection":… (of a record),"epoch":… (low bits),
/// "frames":[[system,component,sequence],…]}
std::string arrivalJson(link::Impairer::Direction direction, Duration sinceStart, const impair::Treatment &verdict,
                        const DatagramContents &contents);
/// {"event":"out","t":…,"direction":…,"sequence":…}
std::string deliveryJson(link::Impairer::Direction direction, Duration sinceStart, std::uint64_t sequence);

} // namespace skyseal::engine
