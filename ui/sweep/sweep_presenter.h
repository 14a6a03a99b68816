// A sweep from the window: asks what to measure, has it measured, and shows it in the diagnostics. While one runs, nobody
// changes the suite by hand.
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
    /// All of it must outlive this; `window` is the dialogs' parent.
    SweepPresenter(SweepInterface &port, SweepPage &page, SuiteActions &suites, QWidget &window);

    bool isRunning() const;
    /// Writes into the view what one that runs on the connected link does to it now. For every view, in their order.
    void mark(ViewState &view);
    /// Opens the dialog, unless a sweep runs.
    void ask(const ViewState &view, bool requireSealed);
    void cancel();
    /// A folder of its own for the files is made inside this one.
    void saveIn(const QString &folder);

Q_SIGNALS:
    /// It began, and its page is to be seen.
    void began();
    void finished();
    /// The page's button.
    void dialogRequested();

private:
    void start(const SweepOrder &order);
    void beginRun(const experiment::Run &run);
    void hold(bool on);
    void askFolder();

    SweepInterface &m_port;
    SweepPage &m_page;
    SuiteActions &m_suites;
    QWidget &m_window;
    std::vector<experiment::SweepArm> m_arms; ///< of the sweep that was started last
    bool m_holdsLink = false;                 ///< one runs, on the connected link
    bool m_plainArm = false;                  ///< plain MAVLink is its present run
    bool m_inClear = false;                   ///< or was the one before, and no session is up again
};

} // namespace skyseal::ui
