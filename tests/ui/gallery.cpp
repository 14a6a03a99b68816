// Draws the window in its states and sizes, and its dialogs, into a folder for people to look at: ui_gallery DIR [STATE SIZE
// THEME], where STATE and the others are lists with commas, "dialogs" among the states being all dialogs.
#include "fake_station.h"
#include "gallery_dialogs.h"
#include "scripted_snapshots.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/window/main_window.h"
#include "ui/security/suite_actions.h"

#include <QtCore/QDir>
#include <QtCore/QSettings>
#include <QtCore/QTemporaryDir>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDockWidget>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// Two stations at the gateway, one of which reads only.
void addClients(engine::Snapshot &snapshot)
{
    engine::LinkSnapshot link;
    link.url = "tcpin:127.0.0.1:5790";
    link.phase = engine::LinkPhase::Listening;
    snapshot.served.push_back(link);
    snapshot.clients.push_back({link.url, "127.0.0.1:50123", "all", {1'284, 0, 0, 0}});
    snapshot.clients.push_back({link.url, "127.0.0.1:50124", "none", {96, 12, 0, 0}});
}

/// Brings the window into a state by the same signals that the engine would send.
void play(FakeStation &station, MainWindow &window, const QString &state, const QString &dock)
{
    if (state == QLatin1String("empty"))
        return;
    if (state == QLatin1String("waiting")) {
        station.show(waitingSnapshot());
        return;
    }
    if (state == QLatin1String("held")) {
        station.show(pendingApprovalSnapshot());
        return;
    }
    if (state == QLatin1String("heldbeside")) {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.systemId = 2;
        snapshot.pendingApproval = pendingApprovalSnapshot().pendingApproval;
        station.show(snapshot);
        station.notify(engine::PlaintextRefused{1, "192.0.2.66:40000", 1, "air-2"});
        return;
    }
    if (auto *raised = window.findChild<QDockWidget *>(dock)) {
        raised->show();
        raised->raise();
    }
    const crypto::SuiteId suites[] = {crypto::SuiteId::ChaCha20Poly1305, crypto::SuiteId::Aes256Gcm, crypto::SuiteId::Rc4,
                                      crypto::SuiteId::Aes256Ctr};
    std::uint64_t number = 0;
    for (int part = 0; part < 4; ++part) {
        for (double t = part * 12.0; t < (part + 1) * 12.0; t += 0.5) {
            engine::Snapshot snapshot = state == QLatin1String("plain")
                ? plainSnapshot(t)
                : sealedSnapshot(t, suites[part], static_cast<std::uint32_t>(part));
            snapshot.samples = samplesOf(number, t, t + 0.5,
                                         state == QLatin1String("plain") ? crypto::SuiteId::None : suites[part],
                                         static_cast<std::uint32_t>(part));
            number += snapshot.samples.size();
            if (state == QLatin1String("switching") && t > 46)
                snapshot.sessions.front().info.pending = crypto::SuiteId::Aes256Cbc;
            if (state == QLatin1String("attack")) {
                snapshot.security = engine::Security::UnderAttack;
                snapshot.sessions.front().forgedLastMinute = 214;
                snapshot.sessions.front().replayedLastMinute = 31;
                snapshot.sessions.front().stats.rx.forged = 214;
                snapshot.sessions.front().stats.rx.replayed = 31;
            }
            if (state == QLatin1String("revoked") && t > 46) {
                snapshot.sessions.clear();
                snapshot.security = engine::Security::Nothing;
                snapshot.vehicles.front().ended = engine::EndedSession{"air-1", channel::DownReason::Revoked, 12.6};
            }
            if (state == QLatin1String("served"))
                addClients(snapshot);
            if (state == QLatin1String("lost") && t > 46)
                snapshot.vehicles.front().state.messageAge = 12.6;
            station.show(snapshot);
        }
    }
    station.notify(channel::SwitchDone{channel::SessionId{7}, suites[2], suites[3], channel::Epoch{3}, false, false,
                                       state == QLatin1String("attack") ? channel::SwitchFailure::NotConfirmed
                                                                        : channel::SwitchFailure::None,
                                       std::chrono::milliseconds(84)});
    station.notify(vehicle::TextReceived{1, {1, 6, "EKF3 IMU0 is using GPS", {}}});
    station.notify(vehicle::TextReceived{1, {2, 4, "Battery 1 low voltage", {}}});
    station.notify(vehicle::TextReceived{1, {3, 3, "PreArm: Compass not calibrated", {}}});
}

} // namespace

int main(int argc, char **argv)
{
    QApplication app(argc, argv);
    const QStringList args = app.arguments();
    if (args.size() < 2)
        return 2;
    const QDir out(args.at(1));
    out.mkpath(QStringLiteral("."));
    QStringList states{QStringLiteral("waiting"), QStringLiteral("sealed"),  QStringLiteral("plain"),
                       QStringLiteral("attack"),  QStringLiteral("revoked"), QStringLiteral("dialogs")};
    QStringList sizes{QStringLiteral("1280x800")}, themes{QStringLiteral("light"), QStringLiteral("dark")};
    if (args.size() > 2)
        states = args.at(2).split(QLatin1Char(','));
    if (args.size() > 3)
        sizes = args.at(3).split(QLatin1Char(','));
    if (args.size() > 4)
        themes = args.at(4).split(QLatin1Char(','));
    if (const auto all = states.indexOf(QStringLiteral("dialogs")); all >= 0) {
        states.removeAt(all);
        states += dialogStates();
    }
    const QString dock = args.value(5, QStringLiteral("dockDiagnostics"));
    for (const QString &theme : themes) {
        for (const QString &size : sizes) {
            for (const QString &state : states) {
                QTemporaryDir folder;
                QSettings store(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
                Settings settings;
                settings.theme = theme == QLatin1String("dark") ? Theme::Dark
                    : theme == QLatin1String("contrast")        ? Theme::HighContrast
                                                                : Theme::Light;
                settings.serving.on = state == QLatin1String("served");
                storeSettings(store, settings);
                FakeStation station;
                ProgramFacts facts;
                facts.demoAvailable = true;
                MainWindow window(station, store, facts);
                window.resize(size.section(QLatin1Char('x'), 0, 0).toInt(), size.section(QLatin1Char('x'), 1).toInt());
                window.show();
                QCoreApplication::processEvents();
                FakeKeyring keyring;
                FakePairing pairing;
                fillKeyring(keyring);
                if (QWidget *dialog = openDialog(state, window, keyring, pairing)) {
                    QCoreApplication::processEvents();
                    dialog->grab().save(out.filePath(QStringLiteral("%1-%2.png").arg(state, theme)));
                    delete dialog;
                    continue;
                }
                play(station, window, state, dock);
                window.findChild<DiagnosticsPanel *>()->refresh();
                QCoreApplication::processEvents();
                window.grab().save(out.filePath(QStringLiteral("%1-%2-%3.png").arg(state, size, theme)));
            }
        }
    }
    return 0;
}
