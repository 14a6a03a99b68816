// Checks the claims of the paper whose experiment a sweep repeats: A. Allouch et al., "MAVSec: Securing the MAVLink Protocol
// for Ardupilot/PX4 Unmanned Aerial Systems", 2019, arXiv:1905.00265.
#pragma once

#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

/// By equivalence within Plan::margin: an interval that lies wholly on one side of the margin decides, and one that reaches
/// over it does not, however the mean lies.
enum class Finding : std::uint8_t { Confirmed, Refuted, NotDecided };
/// "confirmed", "refuted", "not decided"
std::string_view findingText(Finding finding);

struct Claim
{
    std::string_view key; ///< "packets-best"
    std::string text;     ///< paraphrased
    Finding finding{};
    /// With the ratios and intervals that the finding is based on; where it is not decided, with the margin that these data
    /// could have decided.
    std::string reason;
};

/// Claims are judged on the clean link, otherwise under the first condition; packets and CPU under the saturated load, since
/// the natural one leaves every suite idle; and in the paper's framing (inline); each as far as it was measured, and stated in
/// the reason.
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
