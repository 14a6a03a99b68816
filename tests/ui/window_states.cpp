#include "window_states.h"

#include "scripted_snapshots.h"
#include "ui/replay/rescue_bar.h"

#include <QtTest/QTest>

namespace skyseal::ui {

namespace {

/// Two vehicles, one with an empty battery, on a link with forged records.
engine::Snapshot attackedSnapshot()
{
    engine::Snapshot snapshot = sealedSnapshot(5);
    snapshot.security = engine::Security::UnderAttack;
    snapshot.sessions.front().stats.rx.forged = snapshot.sessions.front().forgedLastMinute = 87;
    snapshot.vehicles.front().state.batteryPercent = 8;
    snapshot.vehicles.push_back(snapshot.vehicles.front());
    snapshot.vehicles.back().state.systemId = 2;
    return snapshot;
}

} // namespace

void addWindowStates()
{
    QTest::addColumn<QString>("state");
    for (const char *state :
         {"empty", "waiting", "pending", "plain", "sealed", "attacked", "replay", "demo", "problem", "rescue"})
        QTest::newRow(state) << QString::fromLatin1(state);
}

void enterState(const QString &state, MainWindow &window, FakeStation &station)
{
    if (state == QLatin1String("waiting"))
        station.show(waitingSnapshot());
    else if (state == QLatin1String("pending"))
        station.show(pendingApprovalSnapshot());
    else if (state == QLatin1String("plain"))
        station.show(plainSnapshot(1));
    else if (state == QLatin1String("sealed"))
        station.show(sealedSnapshot(1));
    else if (state == QLatin1String("attacked"))
        station.show(attackedSnapshot());
    else if (state == QLatin1String("replay")) {
        window.startReplay(QStringLiteral("tlog:/logs/field.tlog"));
        station.showReplay(replayedSnapshot(300));
    } else if (state == QLatin1String("demo"))
        window.setDemo(true);
    else if (state == QLatin1String("problem"))
        window.reportProblem(QStringLiteral("The port is in use"), QStringLiteral("Use another"), [] {});
    else if (state == QLatin1String("rescue"))
        window.offerRescue({QStringLiteral("/logs/a.tlog"), {QStringLiteral("udpin:0.0.0.0:14550")}, {}});
    else if (state != QLatin1String("empty"))
        qFatal("no state %s", qPrintable(state));
}

} // namespace skyseal::ui
