// The results of a sweep: every sample as it was measured, the plan, and the setting of machine and programs. Means, figures
// and reports are computed from these.
#pragma once

#include "core/base/reason.h"
#include "core/channel/stats.h"
#include "core/experiment/metric.h"
#include "core/experiment/plan.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace skyseal::experiment {

/// Counters at one moment, counted since the link was opened for a block of runs. Whole numbers, so that the losses of a run
/// can be compared with an independent record of the same link.
struct Counted
{
    struct Frames
    {
        std::uint64_t taken = 0, lost = 0, late = 0, duplicate = 0;
    };
    Frames mavlink;              ///< by MAVLink's sequence numbers
    channel::ReceiveCounters rx; ///< records to the station
    channel::ReceiveCounters tx; ///< records to the agent, by its newest report
    /// Losses at the relay of an impaired link since it started, by its own log; `frames` are clear ones.
    struct Dropped
    {
        std::uint64_t datagrams = 0, records = 0, frames = 0;
    };
    struct Relay
    {
        Dropped toStation, toAgent;
    };
    std::optional<Relay> relay; ///< nullopt without a relay of the sweep
};

/// Power of the idle machine around a launch, in watts; NaN where it is not known.
struct IdlePower
{
    double before = std::numeric_limits<double>::quiet_NaN(), after = before;
    bool isKnown() const { return !std::isnan(before) && !std::isnan(after); }
};

struct Sample
{
    Run run;
    unsigned order = 0; ///< position among all runs of the sweep, from 0
    double start = 0;   ///< seconds since the sweep began
    double seconds = 0; ///< duration of the measurement
    Values values;
    Counted begin, end;                              ///< at the run's edges
    bool isCounted = true;                           ///< false: of an older file, which has no `begin` and `end`
    std::map<std::uint32_t, std::uint64_t> messages; ///< frames that the station accepted, by message id; empty if not known
    Reason problem;                                  ///< why nothing was measured; empty on success
    Reason invalid;                                  ///< why the values are not those of the run's load; empty if they are
    unsigned attempts = 1; ///< a run that is not valid is repeated; the values are those of the last attempt
    bool isJudged = true;  ///< false: of an older program, which did not check whether a run is valid

    /// Its values count. The others are shown with the run itself only.
    bool isValid() const { return problem.empty() && invalid.empty(); }
};

/// Names and values in display order: "machine", "processor", "libsodium", …
using Setting = std::vector<std::pair<std::string, std::string>>;

struct Results
{
    Plan plan;
    Setting setting;
    std::string placement; ///< which core each program ran on; empty if the sweep started none
    std::string source;    ///< what the vehicle is: the sweep's own simulator, or which one on which link; empty if not known
    std::vector<Sample> samples;
    std::vector<std::string> unknown; ///< what an older file, from which these were read, does not hold; sentences
    std::map<crypto::SuiteId, double> contextBytes; ///< heap of one keyed cipher, for each suite where it was measured
    bool complete = false;                          ///< false: cancelled or given up
    double seconds = 0;                             ///< duration of the sweep
};

/// The value of a key of the setting; empty without one.
std::string settingOf(const Setting &setting, std::string_view key);
std::string settingOf(const Results &results, std::string_view key);

/// One cell of the design. Its samples are the repeats of one arm in all launches.
struct Cell
{
    std::size_t condition = 0, load = 0, arm = 0;
    bool operator==(const Cell &) const = default;
};

std::vector<Cell> cells(const Plan &plan);
/// The values of a cell in the order of launches and repeats; NaN where a value could not be measured, and for runs that are
/// not valid.
std::vector<double> valuesOf(const Results &results, const Cell &cell, Metric metric);
/// Sample::order of each value of valuesOf().
std::vector<unsigned> ordersOf(const Results &results, const Cell &cell);

} // namespace skyseal::experiment
