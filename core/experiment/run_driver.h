// Carries out one run of a sweep on a link that works: brings its suite into use, warms up, and measures between two probes,
// whose counters and clock are read at one moment each. In between, the station publishes as little as possible, since that
// would be measured as well. Lives on the station's thread.
//
//   begin() → Switching → WarmingUp → Beginning → Measuring → Ending → Reporting → ended()
//   back to Switching if the link is lost before the measurement began
//
// Input: handleSnapshot() and the other handlers, after LinkDriver has taken the snapshot; without effect while no run is
// carried out.
#pragma once

#include "core/experiment/link_driver.h"
#include "core/experiment/load_settling.h"
#include "core/experiment/run_measurement.h"
#include "core/experiment/stage_timer.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

namespace skyseal::experiment {

class RunDriver : public QObject
{
    Q_OBJECT

public:
    /// `link` and `plan` must outlive this object.
    RunDriver(LinkDriver &link, const Plan &plan, std::function<ProgramUsage()> programs);

    /// `sample` names the run; the link must carry MAVLink as its arm requires. `isFirst`: the programs have just started.
    void begin(const Sample &sample, bool isFirst);
    /// Another attempt at the run that has just ended.
    void repeat() { beginWarmUp(); }
    /// Ends the run without ended().
    void abort() { m_stage.enterUnlimited(Stage::Idle); }

    void handleSnapshot();
    /// Hands the probe to LinkDriver as well, unless it is of a run that was given up meanwhile.
    void handleProbe(const LinkDriver::Snapshot &snapshot);
    void handleSessionUp(const channel::SessionUp &up);
    void handleSwitch(const channel::SwitchDone &done);
    /// To be called some ten times a second.
    void handleTimeout();

Q_SIGNALS:
    /// The measurement began.
    void measuring();
    /// `sample` has the values of the run, or its problem; Metric::SessionMemory stays as it was.
    void ended(const skyseal::experiment::Sample &sample);

private:
    enum class Stage : std::uint8_t {
        Idle,
        Switching,
        WarmingUp,
        Beginning, ///< the first probe of the run is requested
        Measuring,
        Ending,   ///< the last probe of the run is requested
        Reporting ///< the agent's costs are requested
    };

    void enter(Stage stage, Duration patience);
    void beginSwitch();
    void continueSwitch();
    void beginWarmUp();
    bool isWarm(double inStage);
    bool isReported(double inStage, double least);
    void requestBegin();
    void beginMeasuring();
    void watchMeasuring();
    void requestEnd();
    void requestReport();
    void end(Reason problem = {});
    int snapshotsPerSecond() const;
    double now() const { return static_cast<double>(m_clock.nsecsElapsed()) / 1e9; }

    LinkDriver &m_link;
    const Plan &m_plan;
    RunMeasurement m_measurement;
    LoadSettling m_settling;
    StageTimer<Stage> m_stage;
    Sample m_sample; ///< of the run, without values
    bool m_isFirst = false;
    QElapsedTimer m_clock;
    QTimer m_measured{this}; ///< fires at the end of the measurement
};

} // namespace skyseal::experiment
