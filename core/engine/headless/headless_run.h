// Runs a station without a window: executes a flight script, cycles through a list of suites, and reports when the run is
// over and whether its goals were reached. The listener writes the output. Lives on the thread of the Station object.
#pragma once

#include "core/engine/station/station.h"
#include "core/engine/headless/run_task.h"
#include "core/engine/headless/switch_plan.h"
#include "core/vehicle/flight_script_runner.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace skyseal::engine {

struct RunPlan
{
    std::vector<vehicle::FlightStep> script;
    std::vector<crypto::SuiteId> switchTo; ///< cycled through repeatedly
    Duration switchEvery = std::chrono::seconds(1);
    std::optional<Duration> duration;
    bool sessionRequired = false;
    /// All links carry the encryption of MAVSec's published code; nothing is sent on them.
    std::shared_ptr<const crypto::MavsecCipher> mavsec;
    bool inlineRequired = false;    ///< a session must agree to inline framing
    std::vector<ServeConfig> serve; ///< links for other ground stations
    std::shared_ptr<RunTask> task;  ///< the run ends when it has finished
};

/// Called on the run's thread, in the order of the events.
class RunListener
{
public:
    virtual ~RunListener() = default;
    virtual void eventOccurred(const Event &event) = 0;
    virtual void stepEnded(const vehicle::StepReport &report) = 0;
    /// Once a second; `time` is since the start.
    virtual void secondPassed(const Snapshot &snapshot, double time) = 0;
    virtual void ended(const Snapshot &last, double time) = 0;
};

enum class RunOutcome : std::uint8_t {
    Reached,
    NoSession,        ///< a session was required and never came up
    ScriptFailed,     ///< a step failed
    ScriptUnfinished, ///< the run ended before the script
    SuiteNotReached,  ///< a suite of the list was refused or not confirmed, and never used
    TaskFailed,       ///< the task failed, or the run ended before it
    InlineNotReached, ///< the other end does not allow inline framing
    CannotOpen        ///< a link cannot work: its port is taken, its host unknown, its file unreadable; or a file of the task
};

class HeadlessRun : public QObject
{
    Q_OBJECT

public:
    /// `links` are opened by start(). Station and listener must outlive the run.
    HeadlessRun(Station &station, RunListener &listener, RunPlan plan, std::vector<link::LinkUrl> links);

    void start();
    /// Ends the run in an orderly way, as after a signal.
    void stop();
    bool isStopping() const { return m_stopping; }

Q_SIGNALS:
    /// `problem` is a sentence about the goal that was not reached; empty with Reached.
    void finished(skyseal::engine::RunOutcome outcome, std::string problem);

private:
    LinkId addLink(const link::LinkUrl &url);
    void take(const std::shared_ptr<const Snapshot> &snapshot);
    void handleEvent(const Event &event);
    void watchLinks(const LinkSnapshot &link);
    void watchServed(const LinkSnapshot &link);
    void tick();
    void fly(TimePoint now);
    void drainScript();
    void drainTask();
    bool isDue() const;
    void endIfDue();
    double elapsed() const { return static_cast<double>(m_clock.elapsed()) / 1000; }
    void settle(const Snapshot &last);

    Station &m_station;
    RunListener &m_listener;
    RunPlan m_plan;
    std::vector<link::LinkUrl> m_urls;
    vehicle::FlightScriptRunner m_script;
    SwitchPlan m_switching;
    std::map<LinkId, bool> m_links;  ///< whether the link ever worked
    std::map<LinkId, bool> m_played; ///< whether the log has been replayed to its end
    std::shared_ptr<const Snapshot> m_snapshot;
    QElapsedTimer m_clock;
    QTimer m_tick;
    int m_seconds = 0;
    std::optional<double> m_due; ///< since when nothing is left to do, in seconds of the run
    bool m_sessionSeen = false;
    bool m_inlineSeen = false;
    bool m_stopping = false;
    std::string m_brokenLink;
    std::string m_linkProblem; ///< the newest problem of a link that never worked
};

} // namespace skyseal::engine
