// Checks the claims of the paper whose experiment a sweep repeats: A. Allouch et al., "MAVSec: Securing the MAVLink Protocol
// for Ardupilot/PX4 Unmanned Aerial Systems", 2019, arXiv:1905.00265.
#pragma once

#include "core/experiment/results.h"

#include <limits>
#include <string>
#include <vector>

namespace skyseal::experiment {

/// By equivalence within Plan::margin: an interval that lies wholly on one side of the margin decides, and one that reaches
/// over it does not, however the mean lies.
enum class Finding : std::uint8_t { Confirmed, Refuted, NotDecided };
/// "confirmed", "refuted", "not decided"
std::string_view findingText(Finding finding);

/// One ratio that a claim speaks of, with its 95 % interval; without width where it is a count.
struct ClaimRatio
{
    std::string first, second; ///< suites: the first to the second
    double ratio = 0, low = 0, high = 0;
};

struct Claim
{
    std::string_view key; ///< "packets-best"
    std::string text;     ///< paraphrased
    Finding finding{};
    /// With the ratios and intervals that the finding is based on, and the load and link that they are of.
    std::string reason;
    /// The smallest margin above Plan::margin by which these data would decide the claim, 0.05: 5 %. NaN if it is decided, or
    /// if no such margin would.
    double decidable = std::numeric_limits<double>::quiet_NaN();
    /// Below this one, which is smaller than Plan::margin, they would decide it as well. NaN likewise.
    double decidableBelow = std::numeric_limits<double>::quiet_NaN();
    std::vector<ClaimRatio> ratios = {}; ///< as far as they were measured
};

/// Each claim is judged on the clean link and under the load that it speaks of: CPU under the natural one, as in the paper,
/// packets under the saturated one, since the vehicle decides their number otherwise. Where a ratio was not measured there, it
/// is judged under another load or link (CPU: the paced ones first), which the reason states. In the paper's framing (inline),
/// if measured.
std::vector<Claim> paperClaims(const Results &results);

/// The order in which the paper found the ciphers by one quantity, and the one that this sweep found. Only orders are compared:
/// the paper's values are those of another machine.
struct Ordering
{
    std::string quantity; ///< "Packets, the most first"
    std::string paper, here;
};
/// Empty without plain MAVLink or without comparisons.
std::vector<Ordering> orderings(const Results &results);

} // namespace skyseal::experiment
