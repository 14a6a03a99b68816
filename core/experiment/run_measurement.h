// The measurement of one run: reads the counters at its two edges and turns them into a sample. See measurement.h for the
// values. Plain object on the station's thread.
#pragma once

#include "core/experiment/measured_link.h"
#include "core/experiment/measurement.h"
#include "core/metrics/energy_meter.h"

#include <functional>

namespace skyseal::experiment {

class RunMeasurement
{
public:
    /// Problem of a run during which the session ended.
    static constexpr Sentence kSessionEnded = sentence("Reason", "the session did not last through the run");

    using Snapshot = std::shared_ptr<const engine::Snapshot>; ///< at both edges with a probe

    explicit RunMeasurement(std::function<ProgramUsage()> programs) : m_programs(std::move(programs)) {}

    /// The suite of the run is in use, and the agent's costs are requested from now on. A report before may hold the time of
    /// another suite.
    void awaitReport(const MeasuredLink &link, const engine::Snapshot &snapshot);
    /// The agent's costs of the run count from its newest report. Returns false unless one has arrived since awaitReport().
    bool takeReport(const MeasuredLink &link, const engine::Snapshot &snapshot);
    bool hasReport() const { return m_report.has_value(); }
    /// True if the newest report of the agent has no costs: it knows that they are not requested any more.
    static bool costsHaveStopped(const MeasuredLink &link, const engine::Snapshot &snapshot);
    void begin(const MeasuredLink &link, const Snapshot &snapshot);
    /// To be called some ten times a second during the run, for sensors of power.
    void tick();
    /// True if the live session differs from that at the beginning. A short silence of the same session does not count.
    bool sessionChanged(const MeasuredLink &link, const engine::Snapshot &snapshot) const;
    /// True if this new session is with the peer of the session at the beginning, which it replaces.
    bool isReplacedBy(const channel::SessionUp &up) const { return m_peer == up.peer && m_session != up.session; }
    /// Reads all counters at the end of the run but the agent's costs, which are requested then.
    void readEnd(const MeasuredLink &link, const Snapshot &snapshot);
    /// True if the agent's costs of this run are known at its beginning.
    bool hasBeginReport() const { return m_begin.agent.has_value(); }
    /// Takes the first report after the run. Returns false while there is none; without effect in another session.
    bool takeEndReport(const MeasuredLink &link, const engine::Snapshot &snapshot);
    /// Fills seconds, values, validity and counters of the sample, or its problem: the session or the vehicle did not last
    /// through the run. Metric::Switch and Metric::SessionMemory stay as they are.
    void end(const MeasuredLink &link, const Plan &plan, Sample &sample);

private:
    Reading readingOf(const MeasuredLink &link, const Snapshot &snapshot);

    std::function<ProgramUsage()> m_programs;
    metrics::EnergyMeter m_energy;
    Reading m_begin, m_end;
    std::optional<channel::SessionId> m_session;  ///< empty in plain MAVLink
    std::optional<channel::PublicKey> m_peer;     ///< of that session
    std::optional<std::uint32_t> m_reportBefore;  ///< stamp of the agent's newest report at awaitReport()
    std::optional<AgentCostReport> m_report;      ///< from which the agent's costs count
    std::optional<channel::SessionId> m_reporter; ///< the session of that report
};

} // namespace skyseal::experiment
