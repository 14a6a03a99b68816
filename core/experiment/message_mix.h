// Of which messages the traffic of a sweep consisted, as its station received them: the share of each in the frames. Sweeps
// whose vehicles sent other messages measure other links, whatever their options said. Pure functions of the results.
#pragma once

#include "core/experiment/results.h"

#include <cstdint>
#include <map>
#include <string>

namespace skyseal::experiment {

/// Shares from 0 to 1 by message id.
using MessageMix = std::map<std::uint32_t, double>;

/// Sweeps are of one mix where no message's share differs by more.
inline constexpr double kMixTolerance = 0.05;

/// Over all valid runs of the reference, or of the first arm that has any, under this load. Empty if not known: no valid run,
/// or a sweep of a version that did not count them.
MessageMix messageMixOf(const Results &results, std::size_t load);

/// "ATTITUDE 21.3 %, GLOBAL_POSITION_INT 10.7 %, …, 12 others 4.1 %", the most frequent first. Empty for an empty mix.
std::string messageMixText(const MessageMix &mix);

/// Why two sweeps with the same loads are not of one mix: "under the natural load 31 % of the frames of A are ATTITUDE, and
/// 12 % of those of B, …". Empty if they are, or where one of the mixes is not known. Under the saturated load the speed of the
/// machine decides how much of the traffic is load: that is not compared.
std::string mixDifference(const Results &one, const std::string &oneName, const Results &two, const std::string &twoName);

} // namespace skyseal::experiment
