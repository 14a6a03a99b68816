// What a sweep does: which suites, under which conditions and loads, for how long, how often, in which order.
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/channel/policy.h"
#include "core/crypto/suite.h"
#include "core/impair/impairment.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::experiment {

/// How much the vehicle sends: what a station asks for as a rule, or as fast as answers come back.
enum class Load : std::uint8_t { Natural, Saturated };
std::string_view name(Load load);

/// What is compared: a suite in a framing. `again` is the same a second time, under another name: whatever differs between
/// the two is noise (A/A). The framing means nothing for plain MAVLink.
struct SweepArm
{
    crypto::SuiteId suite{};
    bool again = false;
    channel::Framing framing = channel::Framing::Sealed;
    bool operator==(const SweepArm &) const = default;
};
/// "aes-256-gcm"; "aes-256-ctr inline"; "aes-256-gcm (A/A)".
std::string name(const SweepArm &arm);
/// The same, with the framing always said: "aes-256-gcm sealed"; plain MAVLink has none: "none".
std::string fullName(const SweepArm &arm);
/// "sealed", "inline"; "plain" for plain MAVLink.
std::string_view framingName(const SweepArm &arm);
std::string_view name(channel::Framing framing);
/// False for a suite that cannot be in this framing; such an arm is named in every report, and never run.
bool exists(const SweepArm &arm);

/// Every suite in every framing, plain MAVLink once; with `noise`, one of them again: the default suite where it is there.
std::vector<SweepArm> armsOf(const std::vector<crypto::SuiteId> &suites, const std::vector<channel::Framing> &framings,
                             bool noise);

/// Kept for comparison: a broken cipher, or none.
bool isInsecure(const SweepArm &arm);

/// The link that all arms meet alike: clean, or with what an impairment does to both directions.
struct Condition
{
    std::string name = "clean";
    impair::Settings settings;
    bool clean() const { return name == "clean"; }
};

/// "clean", or settings separated by commas: loss=, duplicate=, reorder=, corrupt= (0 to 1), delay=, jitter= (ms),
/// rate= (baud). The text is the condition's name.
Result<Condition, InputError> parseCondition(std::string_view text);

/// The same for people: "57,600 baud, 5 % loss, 20 ms delay"; "clean".
std::string words(const Condition &condition);

struct Plan
{
    std::vector<SweepArm> arms;
    std::vector<Load> loads{Load::Natural};
    std::vector<Condition> conditions{Condition{}};
    Duration measure = std::chrono::seconds(5);       ///< of each run
    Duration warmUp = std::chrono::milliseconds(300); ///< before it, dropped
    unsigned repeats = 3;
    std::uint64_t seed = 1;
};

/// The framings of its arms, sealed first; none when all it has is plain MAVLink.
std::vector<channel::Framing> framingsOf(const Plan &plan);

/// Indices into the plan.
struct Run
{
    std::size_t condition = 0, load = 0, arm = 0;
    unsigned repeat = 0; ///< the first is 0
};

/// A randomised block design: condition by condition and load by load, since changing those restarts programs; within each,
/// every repeat holds every arm that exists once, in an order of its own. So what drifts slowly meets all arms alike. The
/// same seed gives the same order on every machine.
std::vector<Run> schedule(const Plan &plan);

} // namespace skyseal::experiment
