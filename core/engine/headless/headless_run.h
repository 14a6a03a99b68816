// A station's run without a window: flies a script, walks through a list of suites, and says when it is over and whether
// what was asked for was reached. The words and lines are its listener's. Lives on the station's thread.
#pragma once

#include "core/engine/station/station.h"
#include "core/engine/headless/switch_plan.h"
#include "core/vehicle/flight_script_runner.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include <functional>
#include <map>
#include <optional>

namespace skyseal::engine {

struct RunPlan
{
    std::vector<vehicle::FlightStep> script;
    std::vector<crypto::SuiteId> switchTo; ///< walked through again and again
    Duration switchEvery = std::chrono::seconds(1);
    std::optional<Duration> duration;
    bool sessionRequired = false;
    /// All links are read as MAVSec's published code encrypts them, and never sent to.
    std::optional<crypto::MavsecCipher> mavsec;
    bool inlineRequired = false; ///< a session must agree to inline framing
};

/// Told on the run's thread, in the order of what happened.
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
    NoSession,        ///< one was required and never came up
    ScriptFailed,     ///< a step failed
    ScriptUnfinished, ///< the run ended before it
    SuiteNotReached,  ///< a suite of the list was refused or not confirmed, and never came into use
    InlineNotReached, ///< the other end does not allow inline framing
    CannotOpen        ///< a link that cannot work: its port is taken, its host unknown, its file unreadable
};

class HeadlessRun : public QObject
{
    Q_OBJECT

public:
    /// `links` are opened by start(). Station and listener must outlive the run.
    HeadlessRun(Station &station, RunListener &listener, RunPlan plan, std::vector<link::LinkUrl> links);

    void start();
    /// Ends it in good order, as a signal asks.
    void stop();

Q_SIGNALS:
    /// `problem` is a sentence for people about what was not reached; empty with Reached.
    void finished(skyseal::engine::RunOutcome outcome, std::string problem);

private:
    LinkId addLink(const link::LinkUrl &url);
    void take(const std::shared_ptr<const Snapshot> &snapshot);
    void hear(const Event &event);
    void watchLinks(const LinkSnapshot &link);
    void tick();
    void fly(TimePoint now);
    void drainScript();
    void endIfDue();
    double elapsed() const { return static_cast<double>(m_clock.elapsed()) / 1000; }
    void settle(const Snapshot &last);

    Station &m_station;
    RunListener &m_listener;
    RunPlan m_plan;
    std::vector<link::LinkUrl> m_urls;
    vehicle::FlightScriptRunner m_script;
    SwitchPlan m_switching;
    std::map<LinkId, bool> m_links;  ///< whether it ever worked
    std::map<LinkId, bool> m_played; ///< logs that have come to their end
    std::shared_ptr<const Snapshot> m_snapshot;
    QElapsedTimer m_clock;
    QTimer m_tick;
    int m_seconds = 0;
    bool m_sessionSeen = false;
    bool m_inlineSeen = false;
    bool m_stopping = false;
    std::string m_brokenLink;
    std::string m_linkProblem; ///< the last one of a link that has never worked
};

} // namespace skyseal::engine

Q_DECLARE_METATYPE(skyseal::engine::RunOutcome)
