// Carries out the flights of a sweep: the leg to each phase, the landing, and the way down from whatever state the sweep ends
// in.
//
// Sans-I/O. Input: advance() with the newest snapshot, at least ten times a second; handleResult() for the results of requests.
// After each input drain pollRequest(), calling requestSent() for each. Plain object without a thread.
#pragma once

#include "core/experiment/flight_plan.h"
#include "core/vehicle/flight_script_runner.h"

#include <set>

namespace skyseal::engine {
struct Snapshot;
}

namespace skyseal::experiment {

class SweepFlight
{
public:
    explicit SweepFlight(FlightPlan plan) : m_plan(std::move(plan)) {}

    /// True from the first step of a flight until its vehicles are known to be disarmed.
    bool isUp() const { return m_isUp; }
    /// True if the leg that leads to the phase of this block (Run::repeat) has not begun.
    bool needsLeg(unsigned block) const { return m_plan.exists() && m_block != block; }
    /// True if the flight of the last leg has to end before this block is measured.
    bool endsBefore(unsigned block) const { return m_isUp && needsLeg(block) && block % m_plan.phases() == 0; }

    void beginLeg(unsigned block);
    /// The landing of the script, then the same as bringDown() if vehicles are still armed.
    void beginLanding();
    /// Lands the vehicles that the script commands, and disarms those that stay armed. Without force: an autopilot that flies
    /// refuses that.
    void bringDown();
    bool isBringingDown() const { return m_part >= Part::Pausing; }

    void advance(TimePoint now, const engine::Snapshot &snapshot);
    void handleResult(const vehicle::CommandResult &result);
    void handleResult(const vehicle::ParameterResult &result);
    std::optional<vehicle::ScriptRequest> pollRequest();
    void requestSent(vehicle::RequestId id);

    /// True if nothing is flown: the vehicle is in the phase that was wanted, or down, or a step failed.
    bool isFinished() const { return m_part == Part::None; }
    /// Reason why the last leg, landing or way down failed, a sentence with the number of the flight; empty if it did not.
    const std::string &problem() const { return m_problem; }
    /// Reason why the phase ended by itself: a vehicle that was armed when it began is not armed. Empty otherwise.
    std::string endOfPhase(const engine::Snapshot &snapshot) const;

private:
    enum class Part : std::uint8_t { None, Leg, Landing, Pausing, BringingDown, Disarming };

    void run(Part part, std::vector<vehicle::FlightStep> steps);
    void finishPart();
    std::set<std::uint8_t> flown() const;
    std::set<std::uint8_t> armedIn(const engine::Snapshot &snapshot) const;
    void command(Part part, std::string_view order, std::string_view patience);
    std::string inFlight(const std::string &what) const;

    FlightPlan m_plan;
    Part m_part = Part::None;
    std::optional<vehicle::FlightScriptRunner> m_runner;
    std::optional<unsigned> m_block;     ///< whose leg began last, of the flight that is not over
    unsigned m_number = 0;               ///< of the flight, from 1
    std::optional<std::uint8_t> m_first; ///< system id of the vehicle of steps without one
    std::set<std::uint8_t> m_armed;      ///< by the newest snapshot
    std::set<std::uint8_t> m_inPhase;    ///< armed when the phase began
    std::string m_failure;               ///< the step that failed last, and why
    std::string m_problem;
    bool m_isUp = false;
};

} // namespace skyseal::experiment
