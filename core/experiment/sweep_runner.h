// Carries out the plan of a sweep: schedules the runs, brings the link into the state that each of them needs, measures them,
// and restores the link at the end. Decides from the station's snapshots and events. A run is measured between two probes,
// whose counters and clock are read at one moment each; in between, the station publishes as little as possible, since that
// would be measured as well. Lives on the station's thread.
//
//   Connecting → Settling → Switching → WarmingUp → Beginning → Measuring → Ending → (next run: Connecting or Switching)
//   at the end of a block or of the sweep: Restoring → Closing
//   with a flight: Flying before the first run of each phase; Landing after the last one, and before the sweep ends in any way
#pragma once

#include "core/experiment/heap_figures.h"
#include "core/experiment/lab.h"
#include "core/experiment/load_settling.h"
#include "core/experiment/measured_link.h"
#include "core/experiment/results.h"
#include "core/experiment/run_attempts.h"
#include "core/experiment/run_measurement.h"
#include "core/experiment/run_queue.h"
#include "core/experiment/suite_switch.h"
#include "core/experiment/sweep_flight.h"
#include "core/experiment/sweep_stage.h"
#include "core/experiment/sweep_station.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

namespace skyseal::experiment {

struct SweepConfig
{
    Plan plan;
    std::optional<link::LinkUrl> link = std::nullopt;
    engine::StationConfig station; ///< keys and policy; the runner sets the rest
    Lab *lab = nullptr;            ///< null if the far end is not started by this program
    HeapFigures *heap = nullptr;   ///< null: Metric::SessionMemory is not measured
    FlightPlan flight = {};        ///< carried out around the runs; with a lab only, and Plan::phases is that of it
    /// In place of a station of its own, whose link and config are not used then: one with a single sealed session. The plan
    /// has one load and one condition. The sweep ends when this station is destroyed.
    engine::Station *borrowed = nullptr;
};

class SweepRunner : public QObject
{
    Q_OBJECT

public:
    explicit SweepRunner(SweepConfig config);
    ~SweepRunner() override;

    void start();
    /// Restores the link, then ends; the samples so far are kept.
    void cancel();

    const Results &results() const { return m_results; }
    std::size_t runs() const { return m_queue.size(); }
    /// Estimate in seconds until the end.
    double remaining() const { return m_queue.remaining(); }

Q_SIGNALS:
    /// A run began: the link is brought into its state, then it is measured.
    void runBegan(const skyseal::experiment::Run &run);
    void sampleTaken(const skyseal::experiment::Sample &sample);
    /// `problem` is a sentence if the plan was not carried out completely; `opened` is false if no link could be opened.
    void finished(bool opened, const std::string &problem);

private:
    void handleSnapshot(const RunMeasurement::Snapshot &snapshot);
    void handleProbe(const RunMeasurement::Snapshot &snapshot);
    void handleEvent(const engine::Event &event);
    void handleSwitch(const channel::SwitchDone &done);
    void handleTimeout();
    void beginNextRun();
    void openStation();
    void prepareLink();
    void setProtection(std::optional<engine::Protection> protection);
    void beginSwitch();
    void continueSwitch();
    void orderSwitch();
    void beginWarmUp();
    void requestBegin();
    void beginMeasuring();
    void watchRun(const engine::Snapshot &snapshot);
    void requestEnd();
    void endRun(std::string problem = {});
    void addSessionMemory(Sample &sample);
    void refuseRun(const std::string &problem);
    Sample sampleOfRun() const;
    void record(const Sample &sample);
    void beginLeg();
    void beginLanding();
    void bringDown();
    void fly();
    void sendFlightRequests();
    void endLanding();
    void openForLanding();
    void reopen();
    void abandonFlight();
    void failFlight(const std::string &problem);
    void nameSource();
    void restoreLink();
    void continueRestoring();
    void closeStation();
    std::optional<crypto::SuiteId> suiteToResume() const;
    void giveUp(const std::string &problem);
    void end();
    void enter(SweepStage stage, Duration patience);
    int snapshotsPerSecond() const;

    bool isEnding() const { return !m_problem.empty() || m_queue.atEnd(); }
    bool isSettled(double inStage) const;
    bool isWarm(double inStage);
    const SweepArm &arm() const { return m_config.plan.arms[m_queue.current().arm]; }
    const engine::SessionSnapshot *session() const { return m_snapshot ? m_link.session(*m_snapshot) : nullptr; }
    double now() const { return static_cast<double>(m_clock.nsecsElapsed()) / 1e9; }

    SweepConfig m_config;
    Results m_results;
    RunQueue m_queue;
    SweepStation m_station;
    MeasuredLink m_link;
    SuiteSwitch m_switch;
    LoadSettling m_settling;
    RunMeasurement m_measurement;
    SweepFlight m_flight;
    RunMeasurement::Snapshot m_snapshot; ///< the newest one
    bool m_isCurrent = false;            ///< while restoring: it was taken after the last run's orders
    StageTimer m_stage;
    RunAttempts m_attempts;
    QElapsedTimer m_clock;
    double m_runStart = 0;                      ///< seconds since the sweep began
    bool m_fresh = false;                       ///< the station was opened for this run
    bool m_opened = false;                      ///< a link worked at least once
    bool m_reopens = false, m_reopened = false; ///< a fresh link to bring the vehicle down is to be opened, was opened
    std::string m_problem;                      ///< reason why the sweep ends early
    QTimer m_tick{this};
    QTimer m_measured{this}; ///< fires at the end of a run
};

} // namespace skyseal::experiment
