// The interface of the window to a sweep. The application implements it with the runner, tests with a fake.
#pragma once

#include "core/experiment/results.h"
#include "core/link/link_url.h"

#include <QtCore/QObject>
#include <QtCore/QString>

#include <memory>
#include <optional>

namespace skyseal::ui {

/// The link that a sweep measures.
enum class SweepTarget : std::uint8_t {
    Connected, ///< the window's own link, as it is
    Simulated, ///< a simulated vehicle and an agent, started for the sweep
    Autopilot  ///< an agent started for the sweep, beside an autopilot that runs already
};
constexpr bool hasOwnAgent(SweepTarget target)
{
    return target != SweepTarget::Connected;
}

/// The configuration of a sweep.
struct SweepOrder
{
    experiment::Plan plan;
    SweepTarget target = SweepTarget::Connected;
    std::optional<link::LinkUrl> autopilot; ///< of SweepTarget::Autopilot
};

/// The progress of a sweep.
struct SweepProgress
{
    std::size_t done = 0, runs = 0;
    double remaining = 0; ///< seconds
};

/// Lives on the GUI thread; commands return at once.
class SweepInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Returns the reason why no vehicle or agent can be started for a sweep; empty if they can.
    virtual QString ownProgramsDisabledReason() const = 0;
    virtual void start(const SweepOrder &order) = 0;
    /// Restores the suite of the link, then finished() follows.
    virtual void cancel() = 0;
    /// Writes the files of these results into a new folder; saved() follows.
    virtual void save(const experiment::Results &results, const QString &folder) = 0;

Q_SIGNALS:
    void runBegan(const skyseal::experiment::Run &run, const skyseal::ui::SweepProgress &progress);
    void sampleTaken(const skyseal::experiment::Sample &sample, const skyseal::ui::SweepProgress &progress);
    /// `problem` is the reason of an incomplete sweep; otherwise empty.
    void finished(std::shared_ptr<const skyseal::experiment::Results> results, const QString &problem);
    /// `problem` names missing files, or the reason if nothing was `written`.
    void saved(const QString &folder, bool written, const QString &problem);
};

} // namespace skyseal::ui
