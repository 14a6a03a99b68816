// Runs a flight script: from the states of the vehicles it derives the next request, and reports how each step ended. The
// first step that fails ends the script.
//
// Sans-I/O. Input: advance() with the newest states, at least ten times a second; handleResult() for the results of requests.
// After each input drain pollRequest(), calling requestSent() for each, then pollReport().
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/flight_script.h"
#include "core/vehicle/request.h"
#include "core/vehicle/vehicle_state.h"

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace skyseal::vehicle {

enum class StepResult : std::uint8_t { Accepted, Refused, TimedOut, Reached };

/// "accepted", "refused", "timeout", "reached", as in the monitor's `command` events.
std::string_view stepResultName(StepResult result);

struct StepReport
{
    std::uint8_t systemId = 0; ///< 0 if no vehicle was found
    std::size_t number = 0;    ///< 1-based
    std::string step;          ///< as written
    StepResult result{};
    std::string reason;
};

/// Longest wait for a vehicle to appear.
inline constexpr Duration kVehicleTimeout = std::chrono::seconds(30);
/// Longest wait for the result of a request; the clients have shorter time-outs.
inline constexpr Duration kResultTimeout = std::chrono::seconds(60);
/// For this long after a result, the states may still be older than it: they arrive in snapshots, the result at once.
inline constexpr Duration kSettleTime = std::chrono::milliseconds(250);

struct ScriptRequest
{
    std::uint8_t systemId = 0;
    Request request;
};

class FlightScriptRunner
{
public:
    explicit FlightScriptRunner(std::vector<FlightStep> steps) : m_steps(std::move(steps)) {}

    void advance(TimePoint now, std::span<const VehicleState *const> vehicles);
    void handleResult(const CommandResult &result);
    void handleResult(const ParameterResult &result);

    std::optional<ScriptRequest> pollRequest();
    /// `id` is the one that the result of the request just polled will carry.
    void requestSent(RequestId id);
    std::optional<StepReport> pollReport();

    bool finished() const { return m_failed || m_index >= m_steps.size(); }
    bool failed() const { return m_failed; }

private:
    enum class Phase : std::uint8_t { Idle, WaitingForVehicle, WaitingForResult, WaitingForState, Sleeping };

    const VehicleState *pickVehicle(std::span<const VehicleState *const> vehicles);
    void begin(TimePoint now, const VehicleState &vehicle);
    void watch(TimePoint now, const VehicleState &vehicle, const WaitUntil &wait);
    void end(StepResult result, std::string reason = {});

    std::vector<FlightStep> m_steps;
    std::size_t m_index = 0;
    Phase m_phase = Phase::Idle;
    TimePoint m_deadline{};
    std::uint8_t m_firstSystem = 0; ///< the vehicle of steps without a system id; 0 = none known yet
    std::uint8_t m_stepSystem = 0;
    std::optional<RequestId> m_awaited;
    std::optional<ScriptRequest> m_request;
    std::deque<StepReport> m_reports;
    bool m_resultArrived = false;           ///< since the last advance()
    TimePoint m_settled = TimePoint::min(); ///< states are newer than the last result from this time on
    bool m_failed = false;
};

} // namespace skyseal::vehicle
