// What the paper claims whose experiment this repeats, held against a sweep: A. Allouch et al., "MAVSec: Securing the MAVLink
// Protocol for Ardupilot/PX4 Unmanned Aerial Systems", 2019, arXiv:1905.00265.
#pragma once

#include "core/experiment/results.h"

#include <functional>
#include <string>
#include <vector>

namespace skyseal::experiment {

enum class Finding : std::uint8_t { Confirmed, NotConfirmed, CannotBeSaid };
/// "confirmed", "not confirmed", "cannot be said from this data"
std::string_view words(Finding finding);

struct Claim
{
    std::string text; ///< in our words
    Finding finding{};
    std::string reason; ///< with the figures that it rests on
};

/// `contextBytes` gives the heap of one keyed cipher; NaN when it is not known. Judged on the clean link where it is among
/// the conditions, else on the first; packets and CPU under the saturated load where it was measured, since the natural one
/// leaves every suite idle; and in the paper's own framing (inline) where that was measured. Each says where. Differences below
/// 2 % do not count, however sure they are.
std::vector<Claim> paperClaims(const Results &results, const std::function<double(crypto::SuiteId)> &contextBytes);

} // namespace skyseal::experiment
