// A sweep from the window: asks what to measure, has it measured, and shows it in the diagnostics. While one runs, nobody
// changes the suite by hand.
#pragma once

#include "ui/sweep/sweep_permits.h"
#include "ui/sweep/sweep_port.h"

#include <QtCore/QObject>

class QWidget;

namespace skyseal::ui {

class SweepPage;

class SweepControl : public QObject
{
    Q_OBJECT

public:
    /// All of it must outlive this; `window` is the dialogs' parent.
    SweepControl(SweepPort &port, SweepPage &page, SuiteActions &suites, QWidget &window);

    bool isRunning() const;
    /// One runs, on the connected link.
    bool holdsLink() const { return m_holdsLink; }
    /// Opens the dialog, unless a sweep runs.
    void ask(const Scene &scene, bool requireSealed);
    void cancel();
    /// A folder of its own for the files is made inside this one.
    void saveIn(const QString &folder);

Q_SIGNALS:
    /// It began, and its page is to be seen.
    void began();
    void finished();
    /// The page's button.
    void askWanted();

private:
    void start(const SweepOrder &order);
    void hold(bool on);
    void askFolder();

    SweepPort &m_port;
    SweepPage &m_page;
    SuiteActions &m_suites;
    QWidget &m_window;
    bool m_holdsLink = false;
};

} // namespace skyseal::ui
