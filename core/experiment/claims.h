// Checks the claims of the paper whose experiment a sweep repeats: A. Allouch et al., "MAVSec: Securing the MAVLink Protocol
// for Ardupilot/PX4 Unmanned Aerial Systems", 2019, arXiv:1905.00265.
#pragma once

#include "core/experiment/results.h"

#include <functional>
#include <string>
#include <vector>

namespace skyseal::experiment {

enum class Finding : std::uint8_t { Confirmed, NotConfirmed, CannotBeSaid };
/// "confirmed", "not confirmed", "cannot be said from this data"
std::string_view findingText(Finding finding);

struct Claim
{
    std::string text; ///< paraphrased
    Finding finding{};
    std::string reason; ///< with the figures that the finding is based on
};

/// `contextBytes` returns the heap bytes of one keyed cipher, NaN if unknown. Claims are judged on the clean link, otherwise
/// under the first condition; packets and CPU under the saturated load, since the natural one leaves every suite idle; and in
/// the paper's framing (inline); each as far as it was measured, and stated in the reason. Differences below 2 % do not count,
/// even if significant.
std::vector<Claim> paperClaims(const Results &results, const std::function<double(crypto::SuiteId)> &contextBytes);

} // namespace skyseal::experiment
