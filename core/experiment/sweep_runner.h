// Carries out a sweep's plan on a station: brings the link into the state that a run asks for, waits, measures, goes on, and
// in the end leaves the link on the suite that it had. Everything is decided from the station's snapshots, whose counters
// and clock were read at one moment. Lives on the station's thread.
#pragma once

#include "core/engine/station.h"
#include "core/experiment/lab.h"
#include "core/experiment/measurement.h"
#include "core/experiment/results.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include <memory>
#include <optional>

namespace skyseal::experiment {

struct SweepConfig
{
    Plan plan;
    link::LinkUrl link;
    engine::StationConfig station; ///< keys and policy; the rest is the runner's
    Lab *lab = nullptr;            ///< null where the far end is somebody else's
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
    void sampleTaken(const skyseal::experiment::Sample &sample);
    /// `problem` is a sentence when the plan was not carried out whole; `opened` is false when there was no link at all.
    void finished(bool opened, const std::string &problem);

private:
    enum class Stage : std::uint8_t { Idle, Closing, Connecting, Settling, Switching, WarmingUp, Measuring, Restoring };

    void next();
    void enterBlock(const Run &run);
    void openStation();
    void closeStation();
    void take(const std::shared_ptr<const engine::Snapshot> &snapshot);
    void hear(const engine::Happening &happening);
    void advance(const engine::Snapshot &snapshot);
    void switchSuite(const engine::Snapshot &snapshot);
    void beginRun();
    void endRun(std::string problem = {});
    void restore();
    void end();
    void giveUp(const std::string &problem);
    void enter(Stage stage, Duration patience);
    void tick();

    Reading readingOf(const std::shared_ptr<const engine::Snapshot> &snapshot) const;
    const Run &run() const { return m_schedule[m_next]; }
    crypto::SuiteId wantedSuite() const { return m_config.plan.arms[run().arm].suite; }
    bool wantsPlain() const { return wantedSuite() == crypto::SuiteId::None; }

    SweepConfig m_config;
    Results m_results;
    std::vector<Run> m_schedule;
    std::size_t m_next = 0;
    std::unique_ptr<engine::Station> m_station;
    bool m_plain = false;      ///< the present station speaks plain MAVLink
    bool m_opened = false;     ///< a link worked at least once
    std::optional<std::pair<std::size_t, std::size_t>> m_block; ///< condition and load that the lab was started for
    std::optional<crypto::SuiteId> m_firstSuite; ///< that the link had before
    std::optional<channel::SessionId> m_session;
    Stage m_stage = Stage::Idle;
    QElapsedTimer m_clock, m_stageClock;
    Duration m_patience{};
    double m_stageStart = 0; ///< snapshot time
    double m_runStart = 0;
    std::shared_ptr<const engine::Snapshot> m_snapshot;
    Reading m_begin;
    double m_switchTook = std::numeric_limits<double>::quiet_NaN();
    bool m_switchOrdered = false;
    unsigned m_failuresInARow = 0;
    bool m_cancelled = false;
    std::string m_problem;
    QTimer m_tick;
};

} // namespace skyseal::experiment
