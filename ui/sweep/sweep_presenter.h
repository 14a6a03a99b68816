// Connects a sweep to the window: opens the dialog, starts the sweep and shows its results in the diagnostics. While a sweep
// runs on the connected link, the suite cannot be chosen by hand. Lives on the GUI thread.
#pragma once

#include "ui/sweep/sweep_permits.h"
#include "ui/sweep/sweep_interface.h"

#include <QtCore/QObject>

class QWidget;

namespace skyseal::ui {

class SweepPage;

class SweepPresenter : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive this; `window` is the parent of dialogs.
    SweepPresenter(SweepInterface &port, SweepPage &page, SuiteActions &suites, QWidget &window);

    bool isRunning() const;
    /// Sets the state of a sweep on the connected link in `view`. To be called for every view in order.
    void mark(ViewState &view);
    /// Opens the dialog unless a sweep runs.
    void ask(const ViewState &view, bool requireSealed);
    void cancel();
    /// Saves the files in a new folder inside this one.
    void saveIn(const QString &folder);

Q_SIGNALS:
    /// A sweep began; its page is to be shown.
    void began();
    void finished();
    /// The button of the page was clicked.
    void dialogRequested();

private:
    void startOrAsk(const SweepOrder &order);
    void start(const SweepOrder &order);
    void beginRun(const experiment::Run &run);
    void hold(bool on);
    void askFolder();

    SweepInterface &m_port;
    SweepPage &m_page;
    SuiteActions &m_suites;
    QWidget &m_window;
    std::vector<experiment::SweepArm> m_arms; ///< of the last sweep
    bool m_isArmed = false;                   ///< a connected vehicle
    bool m_holdsLink = false;                 ///< a sweep runs on the connected link
    bool m_plainArm = false;                  ///< the current run measures plain MAVLink
    bool m_inClear = false;                   ///< the same, or the run before was plain and no session is up yet
};

} // namespace skyseal::ui
