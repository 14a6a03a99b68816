// A bar at the top of the window, at the start after a run that did not end properly: offers to replay its recording and to
// open its links again. Asks nothing, and takes nothing away when it is dismissed.
#pragma once

#include <QtCore/QDateTime>
#include <QtWidgets/QFrame>

class QPushButton;

namespace skyseal::ui {

/// Remains of a run that ended without closing its files.
struct UnfinishedRun
{
    QString recording; ///< path of the .tlog; empty if there is none
    QStringList links; ///< URLs
    QDateTime ended;   ///< about when
};

class RescueBar : public QFrame
{
    Q_OBJECT

public:
    explicit RescueBar(const UnfinishedRun &run, QWidget *parent = nullptr);

Q_SIGNALS:
    void replayRequested(const QString &file);
    void linksRequested(const QStringList &urls);
};

} // namespace skyseal::ui
