// Flies a flight script: looks at what is known of the vehicles, says what to ask of them next, and reports how each step
// ended. The first step that fails ends the script.
//
// Sans-I/O. Input: advance() with the newest states, at least ten times a second; handleResult() and handleParameterResult()
// for what became of orders. After each of them drain pollOrder() and tell orderSent() the number of each order, then
// pollReport().
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/flight_script.h"
#include "core/vehicle/transfer_result.h"
#include "core/vehicle/vehicle_command.h"
#include "core/vehicle/vehicle_state.h"

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace skyseal::vehicle {

enum class StepResult : std::uint8_t { Accepted, Refused, TimedOut, Reached };

/// "accepted", "refused", "timeout", "reached": the words of the monitor's `command` events.
std::string_view stepResultName(StepResult result);

struct StepReport
{
    std::uint8_t systemId = 0; ///< 0 when no vehicle was ever seen
    std::size_t number = 0;    ///< 1-based
    std::string step;          ///< as written
    StepResult result{};
    std::string reason;
};

/// A vehicle that was not seen yet may take this long to appear.
inline constexpr Duration kVehicleTimeout = std::chrono::seconds(30);
/// Longest wait for the answer to an order; vehicles' commands end by themselves well before.
inline constexpr Duration kAnswerTimeout = std::chrono::seconds(60);
/// After an answer, states handed in may still be from before it for this long (they come as snapshots, the answer at once).
inline constexpr Duration kSettleTime = std::chrono::milliseconds(250);

/// Something that a vehicle is to be asked for.
struct ScriptOrder
{
    std::uint8_t systemId = 0;
    std::variant<VehicleCommand, WriteParameter> request;
};

class FlightScriptRunner
{
public:
    explicit FlightScriptRunner(std::vector<FlightStep> steps) : m_steps(std::move(steps)) {}

    void advance(TimePoint now, std::span<const VehicleState *const> vehicles);
    void handleResult(const CommandResult &result);
    void handleParameterResult(std::uint8_t systemId, const ParameterResult &result);

    std::optional<ScriptOrder> pollOrder();
    /// The number under which the result of the order that was just polled will come; not needed for a parameter.
    void orderSent(CommandId id);
    std::optional<StepReport> pollReport();

    bool finished() const { return m_failed || m_index >= m_steps.size(); }
    bool failed() const { return m_failed; }

private:
    enum class Phase : std::uint8_t { Idle, WaitingForVehicle, WaitingForAnswer, WaitingForState, Sleeping };

    const VehicleState *pickVehicle(std::span<const VehicleState *const> vehicles);
    void begin(TimePoint now, const VehicleState &vehicle);
    void watch(TimePoint now, const VehicleState &vehicle, const WaitUntil &wait);
    void end(StepResult result, std::string reason = {});

    std::vector<FlightStep> m_steps;
    std::size_t m_index = 0;
    Phase m_phase = Phase::Idle;
    TimePoint m_deadline{};
    std::uint8_t m_firstSystem = 0; ///< the vehicle of steps that name none; 0 = none met yet
    std::uint8_t m_stepSystem = 0;
    std::optional<CommandId> m_awaited;
    std::optional<ScriptOrder> m_order;
    std::deque<StepReport> m_reports;
    bool m_answered = false;                ///< an answer came since the last advance()
    TimePoint m_settled = TimePoint::min(); ///< states are believed from here on
    bool m_failed = false;
};

} // namespace skyseal::vehicle
