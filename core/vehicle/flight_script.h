// A flight written down in one line, as `skyseal-cli monitor --do` takes it: "mode GUIDED; arm; takeoff 10; wait
// alt_rel>=9.5 60; land; wait armed==0 90". A number and a colon before a step pick the vehicle ("2: arm").
//
// Grammar: steps separated by ';', empty ones ignored. mode NAME | arm [force] | disarm [force] | takeoff ALT | land | rtl |
// goto LAT LON ALT | altitude ALT | loiter | roi LAT LON [ALT] | roi none | sethome LAT LON | speed V |
// wait FIELD OP VALUE [TIMEOUT] | sleep S | param NAME VALUE | item INDEX | start | reboot | command NUMBER [P1 … P7].
// Altitudes are in metres above home. Keywords are case-insensitive; OP is one of >= <= > < == !=; times are seconds.
#pragma once

#include "core/base/result.h"
#include "core/vehicle/parameter.h"
#include "core/vehicle/state_fields.h"
#include "core/vehicle/vehicle_command.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace skyseal::vehicle {

enum class ComparisonOperator : std::uint8_t { AtLeast, AtMost, Greater, Less, Equal, NotEqual };

/// Waits until the state of the vehicle fulfils a condition. An unknown value fulfils none.
struct WaitUntil
{
    const StateField *field = nullptr;
    ComparisonOperator comparison{};
    double number = 0; ///< of numbers and flags
    std::string text;  ///< of texts, compared ignoring case
    Duration timeout = std::chrono::seconds(60);

    bool fulfilledBy(const VehicleState &state) const;
};

struct Sleep
{
    Duration time{};
};

struct FlightStep
{
    std::optional<std::uint8_t> systemId; ///< nullopt: the first vehicle known to the script
    std::variant<VehicleCommand, WaitUntil, Sleep, WriteParameter> action;
    std::string text;       ///< as written, without the prefix
    std::size_t column = 1; ///< where it begins
};

/// Longest accepted script and most steps in one.
inline constexpr std::size_t kMaxScriptLength = 65536;
inline constexpr std::size_t kMaxScriptSteps = 1000;

/// Parses a script. The error gives step number and column, the text found there and the expected one.
Result<std::vector<FlightStep>, InputError> parseFlightScript(std::string_view script);

/// Parses a condition alone, "battery_percent>=90": FIELD OP VALUE of the grammar above. `column` is that of its first
/// character, for the error.
Result<WaitUntil, InputError> parseCondition(std::string_view condition, std::size_t column = 1);

/// The canonical spelling of a step, prefix included; parses to the same step.
std::string toText(const FlightStep &step);

} // namespace skyseal::vehicle
