// The plan of a sweep: suites, framings, link conditions, loads, duration and repeats of the runs, and their random order.
#pragma once

#include "core/base/clock.h"
#include "core/base/reason.h"
#include "core/base/result.h"
#include "core/crypto/mavsec_kind.h"
#include "core/crypto/suite.h"
#include "core/impair/impairment.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::experiment {

/// The traffic of the vehicle: the streams that a station usually requests, alone; with as much more as answers come back; or
/// with so many frames a second more, on a schedule fixed in advance.
struct Load
{
    enum class Kind : std::uint8_t { Natural, Saturated, Paced };
    static const Load Natural, Saturated;
    static constexpr Load paced(std::uint32_t perSecond) { return {Kind::Paced, perSecond}; }

    Kind kind{};
    std::uint32_t perSecond = 0; ///< of a paced load: 1 to kMostPaced
    bool isPaced() const { return kind == Kind::Paced; }
    bool operator==(const Load &) const = default;
};
inline constexpr Load Load::Natural{Load::Kind::Natural}, Load::Saturated{Load::Kind::Saturated};
inline constexpr std::uint32_t kMostPaced = 1'000'000;
/// "natural", "saturated", "pps500"
std::string name(Load load);
/// The same as a value, for the sentences that the window translates.
Reason nameReason(Load load);
std::optional<Load> loadFromName(std::string_view name);

/// How an arm protects MAVLink frames.
enum class ArmFraming : std::uint8_t {
    Sealed, ///< whole frames in records
    Inline, ///< payloads sealed in place
    Bare    ///< INSECURE, as in the paper: the vehicle encrypts payloads by the suite's cipher, one way and without its HMAC
};
inline constexpr ArmFraming kFramings[] = {ArmFraming::Sealed, ArmFraming::Inline, ArmFraming::Bare};

/// One alternative of the comparison: a suite in a framing. `again` marks the repetition of another arm under a second name:
/// any difference between the two is noise (A/A). The framing has no meaning for plain MAVLink.
struct SweepArm
{
    crypto::SuiteId suite{};
    bool again = false;
    ArmFraming framing = ArmFraming::Sealed;
    bool operator==(const SweepArm &) const = default;
};
/// "aes-256-gcm"; "aes-256-ctr inline"; "aes-256-ctr bare"; "aes-256-gcm (A/A)".
std::string name(const SweepArm &arm);
/// The same, always with the framing: "aes-256-gcm sealed". Plain MAVLink has none: "none".
std::string fullName(const SweepArm &arm);
/// name() and fullName() as values, for the sentences that the window translates.
Reason nameReason(const SweepArm &arm);
Reason fullNameReason(const SweepArm &arm);
/// "sealed", "inline", "bare"; "plain" for plain MAVLink.
std::string_view framingName(const SweepArm &arm);
std::string_view name(ArmFraming framing);
std::optional<ArmFraming> framingFromName(std::string_view name);
/// The cipher of a bare arm that exists; nullopt for all others.
std::optional<crypto::MavsecKind> bareCipherOf(const SweepArm &arm);
/// False if the suite does not support the framing. Such an arm is listed in every report, but never run.
bool exists(const SweepArm &arm);

/// Every suite in every framing, plain MAVLink once. With `noise` one of them is repeated: the default suite if it is included.
std::vector<SweepArm> armsOf(const std::vector<crypto::SuiteId> &suites, const std::vector<ArmFraming> &framings, bool noise);

/// True for research suites, bare ciphers and plain MAVLink.
bool isInsecure(const SweepArm &arm);

/// The link that all arms share: clean, or impaired in both directions.
struct Condition
{
    std::string name = "clean";
    impair::ImpairmentSettings settings;
    bool clean() const { return name == "clean"; }
};

/// "clean", or settings separated by commas: loss=, duplicate=, reorder=, corrupt= (0 to 1), delay=, jitter= (ms),
/// rate= (baud). The text is the condition's name.
Result<Condition, InputError> parseCondition(std::string_view text);

/// For humans: "57,600 baud, 5 % loss, 20 ms delay"; "clean".
std::string conditionText(const Condition &condition);

struct Plan
{
    std::vector<SweepArm> arms;
    std::vector<Load> loads{Load::Natural};
    std::vector<Condition> conditions{Condition{}};
    Duration measure = std::chrono::seconds(5); ///< of each run
    Duration warmUp = std::chrono::seconds(2);  ///< before each, not measured; four times as long before the first of a block
    unsigned launches = 1;                      ///< how often all programs start anew
    unsigned repeats = 3;                       ///< of each arm within each launch, condition and load: with flights, phases
    std::string flight = {};                    ///< script of the flight that is repeated; empty: none
    unsigned phases = 1;                        ///< of each flight, one block of runs each
    std::uint64_t seed = 1;
    double margin = 0.03; ///< a smaller relative difference has no practical effect; claims are judged by it
};

/// The framings of the arms, in the order of kFramings; empty if the only arm is plain MAVLink.
std::vector<ArmFraming> framingsOf(const Plan &plan);

/// Indices into the plan.
struct Run
{
    std::size_t condition = 0, load = 0, arm = 0;
    unsigned repeat = 0; ///< within the launch; the first is 0
    unsigned launch = 0; ///< the first is 0
};

/// A randomised block design, launch after launch. Within a launch, runs of one condition and load follow each other, since
/// changing these restarts programs as well. There each repeat is a block that contains every existing arm once, in a random
/// order of its own, so that slow drift affects all arms alike. The same seed gives the same order on every machine.
std::vector<Run> schedule(const Plan &plan);

/// Calls `each` with the condition and the load of every place in which the arms are compared.
template<typename Each> void forEachPlace(const Plan &plan, Each each)
{
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < plan.loads.size(); ++load)
            each(condition, load);
    }
}

/// The phase of the flight in which the run is measured, from 0.
unsigned phaseOf(const Plan &plan, const Run &run);

/// With this seed, a plan of one launch is that launch of `plan`.
std::uint64_t seedOf(const Plan &plan, unsigned launch);

} // namespace skyseal::experiment
