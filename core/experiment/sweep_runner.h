// Carries out the plan of a sweep: takes the runs one after the other, opens the link for each block of them, has it carry
// MAVLink as the arm of the run requires, and restores it at the end. RunDriver measures the runs and FlightDriver flies; this
// class decides which of them acts on the station's next snapshot or event, and keeps the results. Lives on the station's
// thread.
//
//   Connecting → Settling → Running → (next run: Connecting or Running; from a bare cipher: Clearing → Connecting)
//   at the end of a block or of the sweep: Restoring → Closing
//   with a flight: Flying before the first run of each phase; Landing after the last one, and before the sweep ends in any way
#pragma once

#include "core/experiment/flight_driver.h"
#include "core/experiment/heap_figures.h"
#include "core/experiment/lab.h"
#include "core/experiment/link_driver.h"
#include "core/experiment/results.h"
#include "core/experiment/run_attempts.h"
#include "core/experiment/run_driver.h"
#include "core/experiment/run_queue.h"
#include "core/experiment/stage_timer.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

namespace skyseal::experiment {

struct SweepConfig
{
    Plan plan;
    std::optional<link::LinkUrl> link = std::nullopt;
    engine::StationConfig station; ///< keys and policy; the runner sets the rest
    Lab *lab = nullptr;            ///< null if the far end is not started by this program
    std::string bareKey = {};      ///< file of the key of bare ciphers, as Lab::bareKey()
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
    /// `problem`: why the plan was not carried out completely, empty if it was; `opened` is false if no link could be opened.
    void finished(bool opened, const skyseal::Reason &problem);

private:
    enum class Stage : std::uint8_t {
        Idle,
        Closing,
        Clearing, ///< the vehicle stops to encrypt payloads
        Connecting,
        Settling,
        Running, ///< RunDriver acts
        Flying,  ///< FlightDriver acts, in this stage and the next one
        Landing,
        Restoring
    };

    void listen();
    void handleSnapshot(const LinkDriver::Snapshot &snapshot);
    void handleProbe(const LinkDriver::Snapshot &snapshot);
    void handleEvent(const engine::Event &event);
    void handleLink(const engine::LinkSnapshot &link);
    void handleClosed();
    void handleTimeout();
    void beginNextRun();
    void openStation();
    void prepareLink();
    void changeLink();
    bool isConnected() const;
    void endRun(Sample sample);
    void endRun(const Reason &problem);
    void addSessionMemory(Sample &sample);
    void refuseRun(const Reason &problem);
    Sample sampleOfRun() const;
    void record(const Sample &sample);
    void failFlight(const Reason &problem);
    void addProblem(const Reason &problem);
    void restoreLink();
    void continueRestoring();
    void closeStation();
    void giveUp(const Reason &problem);
    void end();
    void enter(Stage stage, Duration patience);

    bool isEnding() const { return !m_problem.empty() || m_queue.atEnd(); }
    const SweepArm &arm() const { return m_config.plan.arms[m_queue.current().arm]; }
    double now() const { return static_cast<double>(m_clock.nsecsElapsed()) / 1e9; }

    const SweepConfig m_config;
    Results m_results;
    RunQueue m_queue;
    RunAttempts m_attempts;
    LinkDriver m_link;
    RunDriver m_run;
    FlightDriver m_flight;
    StageTimer<Stage> m_stage;
    QElapsedTimer m_clock;
    double m_runStart = 0; ///< seconds since the sweep began
    bool m_fresh = false;  ///< the station was opened for this run
    bool m_opened = false; ///< a link worked at least once
    Reason m_problem;      ///< why the sweep ends early
    QTimer m_tick{this};
};

} // namespace skyseal::experiment
