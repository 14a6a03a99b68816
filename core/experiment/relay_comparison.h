// The loss that the station measured in a run beside the number of units that the relay of the impaired link dropped in that
// time, by the relay's own log. Pure functions of the results.
#pragma once

#include "core/experiment/results.h"

#include <optional>
#include <string>
#include <string_view>

namespace skyseal::experiment {

/// To the station. Units are records, or frames where the link carries clear MAVLink: what sequence numbers of the link count.
struct RelayComparison
{
    std::string_view unit; ///< "records", "frames"
    std::uint64_t received = 0;
    std::int64_t lost = 0;    ///< measured; late arrivals of the time before the run reduce it
    std::int64_t dropped = 0; ///< by the relay

    std::int64_t difference() const { return lost - dropped; }
};

/// nullopt without a relay, for a run without values, and where sequence numbers do not count the loss.
std::optional<RelayComparison> comparedWithRelay(const Plan &plan, const Sample &sample);

/// HTML; empty if no run can be compared.
std::string relayTable(const Results &results);

} // namespace skyseal::experiment
