// Carries out a sweep's plan on a station: brings the link into the state that a run asks for, waits, measures, goes on, and
// in the end leaves the link on the suite that it had. Everything is decided from the station's snapshots, whose counters
// and clock were read at one moment. Lives on the station's thread.
//
// The station is one of its own, or one that is there already (a window's). That one keeps its links and vehicles; only how
// it carries MAVLink changes, and in the end, whatever ended it, it carries it as before.
#pragma once

#include "core/engine/station/station.h"
#include "core/experiment/heap_figures.h"
#include "core/experiment/lab.h"
#include "core/experiment/measurement.h"
#include "core/experiment/results.h"
#include "core/experiment/time_left.h"
#include "core/metrics/energy_meter.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include <map>
#include <memory>
#include <optional>

namespace skyseal::experiment {

struct SweepConfig
{
    Plan plan;
    std::optional<link::LinkUrl> link = std::nullopt;
    engine::StationConfig station; ///< keys and policy; the rest is the runner's
    Lab *lab = nullptr;            ///< null where the far end is somebody else's
    HeapFigures *heap = nullptr;   ///< null where nobody asked what a session takes
    /// In place of a station of its own, whose link and config are not used then: one with a single sealed session. The plan
    /// has one load and one condition. The sweep ends when the station goes.
    engine::Station *borrowed = nullptr;
};

class SweepRunner : public QObject
{
    Q_OBJECT

public:
    explicit SweepRunner(SweepConfig config);
    ~SweepRunner() override;

    void start();
    /// Ends after putting the link back on its suite; what was measured so far is kept.
    void cancel();

    const Results &results() const { return m_results; }
    std::size_t runs() const { return m_schedule.size(); }
    /// Seconds until the end, from how long the runs so far have taken.
    double remaining() const;

Q_SIGNALS:
    /// The link is brought into the state that this run asks for, and then it is measured.
    void runBegan(const skyseal::experiment::Run &run);
    void sampleTaken(const skyseal::experiment::Sample &sample);
    /// `problem` is a sentence when the plan was not carried out whole; `opened` is false when there was no link at all.
    void finished(bool opened, const std::string &problem);

private:
    static constexpr Duration kConnectPatience = std::chrono::seconds(20);
    enum class Stage : std::uint8_t { Idle, Closing, Connecting, Settling, Switching, WarmingUp, Measuring, Restoring };

    void next();
    void enterBlock(const Run &run);
    void openStation();
    void listen();
    void closeStation();
    void giveBack();
    void protect(std::optional<engine::Protection> protection);
    void connectUp(const engine::Snapshot &snapshot);
    void take(const std::shared_ptr<const engine::Snapshot> &snapshot);
    void hear(const engine::Event &event);
    void hearSwitch(const channel::SwitchDone &done);
    void advance(const engine::Snapshot &snapshot);
    void beginSwitching(const engine::Snapshot &snapshot);
    void switchSuite(const engine::Snapshot &snapshot);
    void order(channel::SessionId session, crypto::SuiteId suite);
    double tookOf(const channel::SwitchDone &done) const;
    void beginRun();
    void endRun(std::string problem = {});
    void noteReport(const engine::Snapshot &snapshot);
    void refuseRun(const std::string &problem);
    void record(Sample sample);
    bool beginsBlock(std::size_t run) const;
    void restore();
    void putBack(const engine::Snapshot &snapshot);
    void end();
    void giveUp(const std::string &problem);
    void enter(Stage stage, Duration patience);
    void tick();

    static double tripsOf(const engine::Snapshot &snapshot);
    Reading readingOf(const std::shared_ptr<const engine::Snapshot> &snapshot);
    double warmUpOf(const engine::Snapshot &snapshot) const;
    const Run &run() const { return m_schedule[m_next]; }
    crypto::SuiteId wantedSuite() const { return m_config.plan.arms[run().arm].suite; }
    engine::Protection wantedProtection() const;
    bool isPlain() const { return m_protection == engine::Protection::Plain; }
    const engine::SessionSnapshot *session(const engine::Snapshot &snapshot) const;
    bool isUnderWantedSuite(const engine::Snapshot &snapshot) const;
    bool isAnotherSession(const engine::Snapshot &snapshot) const;
    bool speaks(const engine::Snapshot &snapshot, const engine::VehicleSnapshot &vehicle) const;
    bool vehicleSpeaks(const engine::Snapshot &snapshot) const;
    bool vehicleReady(const engine::Snapshot &snapshot) const;

    SweepConfig m_config;
    Results m_results;
    std::vector<Run> m_schedule;
    TimeLeft m_timeLeft;
    std::size_t m_next = 0;
    std::unique_ptr<engine::Station> m_own;
    engine::Station *m_station = nullptr;           ///< that, or the borrowed one
    std::optional<engine::Protection> m_protection; ///< as the station was told
    std::optional<channel::SessionId> m_ended;      ///< a session that the last change of protection ends
    double m_tripsBefore = 0;                       ///< TIMESYNC answers until then
    bool m_fresh = false;                           ///< the station was opened for this run
    channel::Framing m_framing{};                   ///< that the newest session agreed to
    bool m_plainRefused = false;                    ///< by the agent's offer, or because nothing was heard in clear
    bool m_plainWorked = false;                     ///< once, so that silence is the link's
    bool m_inlineRefused = false;
    bool m_opened = false;                                      ///< a link worked at least once
    std::optional<std::pair<std::size_t, std::size_t>> m_block; ///< condition and load that the lab was started for
    std::optional<crypto::SuiteId> m_firstSuite;                ///< that the link had before
    std::optional<channel::SessionId> m_session;
    Stage m_stage = Stage::Idle;
    QElapsedTimer m_clock, m_stageClock;
    Duration m_patience{};
    double m_stageStart = 0; ///< snapshot time
    double m_runStart = 0, m_lastEnd = 0;
    std::shared_ptr<const engine::Snapshot> m_snapshot;
    Reading m_begin;
    std::optional<std::uint32_t> m_reportBefore; ///< stamp of the agent's newest report when the run began
    metrics::EnergyMeter m_energy;
    double m_switchTook = std::numeric_limits<double>::quiet_NaN();
    std::optional<channel::SessionId> m_switchOrdered; ///< of this session, for this run
    unsigned m_orders = 0;                             ///< in this run
    QElapsedTimer m_firstOrder;
    unsigned m_switchesFailed = 0; ///< in this run: not confirmed in time
    unsigned m_failuresInARow = 0;
    bool m_cancelled = false;
    std::string m_problem;
    QTimer m_tick{this};
};

} // namespace skyseal::experiment
