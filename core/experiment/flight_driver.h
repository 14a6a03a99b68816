// Carries out the flights of a sweep over its link: hands SweepFlight what the station hears, sends its requests, and brings
// the vehicle down before the sweep ends in any way. Where that fails over the link of the runs, the lab and the station are
// started anew for a last attempt over a fresh link. Lives on the station's thread.
//
//   beginLeg() → Flying → legEnded()
//   beginLanding(), bringDown() → Landing → down()
//   the last attempt: Landing → Reopening → Connecting → Settling → Landing → down()
//
// Input: handleSnapshot() and the other handlers, after LinkDriver has taken the snapshot; without effect while nothing is
// flown.
#pragma once

#include "core/experiment/lab.h"
#include "core/experiment/link_driver.h"
#include "core/experiment/stage_timer.h"
#include "core/experiment/sweep_flight.h"

#include <QtCore/QElapsedTimer>

#include <utility>

namespace skyseal::experiment {

class FlightDriver : public QObject
{
    Q_OBJECT

public:
    /// `link` and `lab` must outlive this object; `lab` may be null if the plan has no flight. `seed`: of the lab.
    FlightDriver(LinkDriver &link, Lab *lab, FlightPlan plan, std::uint64_t seed)
        : m_link(link), m_lab(lab), m_seed(seed), m_flight(std::move(plan))
    {
        m_clock.start();
    }

    const SweepFlight &flight() const { return m_flight; }
    /// SweepFlight::endOfPhase() by the newest snapshot.
    std::string endOfPhase() const;

    void beginLeg(unsigned block);
    void beginLanding();
    /// In place of whatever is flown.
    void bringDown();

    void handleSnapshot();
    void handleResult(const vehicle::CommandResult &result) { m_flight.handleResult(result); }
    void handleResult(const vehicle::ParameterResult &result) { m_flight.handleResult(result); }
    /// The station has closed.
    void handleClosed();
    /// To be called some ten times a second.
    void handleTimeout();

Q_SIGNALS:
    /// `problem` is a sentence, empty if the vehicle is in the phase.
    void legEnded(const std::string &problem);
    /// Comes before down(), once for each attempt that failed. `problem` is a sentence.
    void landingFailed(const std::string &problem);
    void down();

private:
    enum class Stage : std::uint8_t {
        Idle,
        Flying, ///< to the phase of the next runs
        Landing,
        Reopening, ///< the station closes
        Connecting,
        Settling
    };

    void enter(Stage stage, Duration patience);
    void begin(Stage stage);
    void fly();
    void endLanding();
    void reopen();
    void openFresh();
    void abandon();
    double now() const { return static_cast<double>(m_clock.nsecsElapsed()) / 1e9; }

    LinkDriver &m_link;
    Lab *m_lab;
    const std::uint64_t m_seed;
    SweepFlight m_flight;
    StageTimer<Stage> m_stage;
    bool m_reopened = false; ///< the link is the fresh one
    QElapsedTimer m_clock;
};

} // namespace skyseal::experiment
