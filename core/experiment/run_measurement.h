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
    static constexpr const char *kSessionEnded = "the session did not last through the run";

    using Snapshot = std::shared_ptr<const engine::Snapshot>; ///< at both edges with a probe

    explicit RunMeasurement(std::function<ProgramUsage()> programs) : m_programs(std::move(programs)) {}

    /// The suite of the run is in use: reports of the agent that arrive from now on tell its costs. The one before may hold the
    /// time of another suite.
    void awaitReport(const MeasuredLink &link, const engine::Snapshot &snapshot);
    /// True if one has arrived since, or if none is to come: in plain MAVLink.
    bool isReported(const MeasuredLink &link, const engine::Snapshot &snapshot) const;
    /// The agent's costs count from its newest report, if that arrived since awaitReport().
    void begin(const MeasuredLink &link, const Snapshot &snapshot);
    /// To be called some ten times a second during the run, for sensors of power.
    void tick();
    /// Takes the first report of the run where begin() had none. To be called with each snapshot of the run, if there are any.
    void noteReport(const MeasuredLink &link, const engine::Snapshot &snapshot);
    /// True if the live session differs from that at the beginning. A short silence of the same session does not count.
    bool sessionChanged(const MeasuredLink &link, const engine::Snapshot &snapshot) const;
    /// True if this new session is with the peer of the session at the beginning, which it replaces.
    bool isReplacedBy(const channel::SessionUp &up) const { return m_peer == up.peer && m_session != up.session; }
    /// Fills seconds, values, validity and counters of the sample, or its problem: the session or the vehicle did not last
    /// through the run. Metric::Switch and Metric::SessionMemory stay as they are.
    void end(const MeasuredLink &link, const Snapshot &snapshot, const Plan &plan, Sample &sample);

private:
    Reading readingOf(const MeasuredLink &link, const Snapshot &snapshot);

    std::function<ProgramUsage()> m_programs;
    metrics::EnergyMeter m_energy;
    Reading m_begin;
    std::optional<channel::SessionId> m_session; ///< empty in plain MAVLink
    std::optional<channel::PublicKey> m_peer;    ///< of that session
    std::optional<std::uint32_t> m_reportBefore; ///< stamp of the agent's newest report at awaitReport()
};

} // namespace skyseal::experiment
