#include "gallery_dialogs.h"
#include "fake_station.h"
#include "fake_sweep.h"
#include "scripted_snapshots.h"

#include "core/log/log_index.h"
#include "ui/dialogs/help_dialog.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/flight/add_waypoint_dialog.h"
#include "ui/flight/change_altitude_dialog.h"
#include "ui/flight/pre_arm_dialog.h"
#include "ui/flight/take_off_dialog.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/keys/change_passphrase_dialog.h"
#include "ui/keys/keys_dialog.h"
#include "ui/keys/pairing_dialog.h"
#include "ui/keys/passphrase_dialog.h"
#include "ui/keys/peer_dialog.h"
#include "ui/links/link_dialog.h"
#include "ui/map/map_source_dialog.h"
#include "ui/map/region_dialog.h"
#include "ui/overlays/overlay_dialog.h"
#include "ui/replay/recordings_dialog.h"
#include "ui/shortcuts/shortcut_dialog.h"
#include "ui/shortcuts/shortcut_edit.h"
#include "ui/sweep/sweep_dialog.h"
#include "ui/values/values_editor.h"
#include "ui/window/command_palette.h"

#include <QtGui/QAction>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include <functional>
#include <map>

namespace skyseal::ui {

namespace {

/// Bytes that look like a key.
channel::PublicKey keyOf(std::uint8_t seed)
{
    channel::PublicKey out{};
    std::uint32_t state = seed;
    for (std::uint8_t &byte : out) {
        state = state * 1664525u + 1013904223u;
        byte = static_cast<std::uint8_t>(state >> 24);
    }
    return out;
}

KnownPeer peerOf(const char *name, std::uint8_t seed)
{
    KnownPeer out;
    out.name = QLatin1String(name);
    out.key = keyOf(seed);
    out.lastSeen = QDateTime(QDate(2026, 5, 14), QTime(9, 30));
    return out;
}

struct Stage
{
    MainWindow &window;
    FakeKeyring &keyring;
    FakePairing &pairing;
};

/// One sealed flight, one without notes about ciphers, one with damaged ones, one that is still being read.
QWidget *recordingsOf(const Stage &stage)
{
    using namespace std::chrono_literals;
    auto *station = new FakeStation(&stage.window);
    auto *dialog = new RecordingsDialog(*station, QStringLiteral("/home/ann/.local/share/skyseal/skyseal/logs"), &stage.window);
    std::vector<engine::RecordingInfo> all;
    for (const char *name : {"2026-05-02T10-00-00Z", "2026-05-01T16-20-11Z", "2026-04-27T08-03-54Z", "2026-04-26T11-41-30Z"}) {
        engine::RecordingInfo one{"/logs/" + std::string(name) + ".tlog", std::string(name) + ".tlog"};
        one.bytes = 3'100'000 + 450'000 * all.size();
        one.modified = WallTime(1'777'716'000s - 86'400s * static_cast<int>(all.size()));
        all.push_back(std::move(one));
    }
    const tlog::LogIndex flight = *replayedSnapshot(0).replay->index;
    tlog::LogIndex plain = flight, damaged = flight;
    plain.suites.clear();
    damaged.suites.resize(1);
    damaged.unreadableEvents = 2;
    all[0].index = std::make_shared<const tlog::LogIndex>(flight);
    all[1].index = std::make_shared<const tlog::LogIndex>(plain);
    all[2].index = std::make_shared<const tlog::LogIndex>(damaged);
    Q_EMIT station->recordingsListed(all);
    return dialog;
}

QWidget *keysOf(const Stage &stage)
{
    auto *dialog = new KeysDialog(stage.keyring, &stage.window);
    dialog->offerPairing();
    return dialog;
}

PairingQuestion question(const char *name)
{
    return {keyOf(9), QLatin1String(name), QStringLiteral("482 907"), 1};
}

QWidget *pairingWith(const Stage &stage, const std::function<void(FakePairing &)> &what)
{
    auto *dialog = new PairingDialog(stage.pairing, stage.keyring, &stage.window);
    dialog->show();
    what(stage.pairing);
    return dialog;
}

/// The one that an entry of the menus opens.
template<typename Dialog> QWidget *byAction(const Stage &stage, const char *action)
{
    stage.window.findChild<QAction *>(QLatin1String(action))->trigger();
    return stage.window.findChild<Dialog *>();
}

VehicleCommands &commandsOf(const Stage &stage)
{
    return *stage.window.findChild<VehicleCommands *>();
}

using Open = std::function<QWidget *(const Stage &)>;

const std::map<QString, Open> &dialogs()
{
    static const std::map<QString, Open> all{
        {QStringLiteral("keys"), &keysOf},
        {QStringLiteral("keys-empty"),
         [](const Stage &stage) {
             stage.keyring.list.peers.clear();
             stage.keyring.own.sealed = false;
             return keysOf(stage);
         }},
        {QStringLiteral("peer"),
         [](const Stage &stage) -> QWidget * {
             return new PeerDialog(stage.keyring, stage.keyring.list.peers[1], &stage.window);
         }},
        {QStringLiteral("passphrase"),
         [](const Stage &stage) -> QWidget * {
             return new PassphraseDialog(stage.keyring.own.file, RefusedPassphrase::Typed, stage.keyring.own.keyringProblem,
                                         &stage.window);
         }},
        {QStringLiteral("passphrase-change"),
         [](const Stage &stage) -> QWidget * { return new ChangePassphraseDialog(stage.keyring, &stage.window); }},
        {QStringLiteral("pairing"), [](const Stage &stage) { return pairingWith(stage, [](FakePairing &) {}); }},
        {QStringLiteral("pairing-differs"),
         [](const Stage &stage) {
             return pairingWith(stage, [](FakePairing &pairing) { Q_EMIT pairing.passphraseDiffers(); });
         }},
        {QStringLiteral("pairing-compare"),
         [](const Stage &stage) {
             return pairingWith(stage, [](FakePairing &pairing) { Q_EMIT pairing.seen(question("heron")); });
         }},
        {QStringLiteral("pairing-fingerprints"),
         [](const Stage &stage) {
             auto *dialog = pairingWith(stage, [](FakePairing &pairing) { Q_EMIT pairing.seen(question("heron")); });
             dialog->findChild<QPushButton *>(QStringLiteral("pairingFingerprints"))->click();
             return dialog;
         }},
        {QStringLiteral("pairing-passphrase"),
         [](const Stage &stage) {
             auto *dialog = pairingWith(stage, [](FakePairing &) {});
             auto *field = dialog->findChild<QLineEdit *>(QStringLiteral("pairingPassphrase"));
             field->setText(QStringLiteral("blue heron"));
             Q_EMIT field->textEdited(field->text());
             Q_EMIT field->editingFinished();
             Q_EMIT stage.pairing.seen(question("heron"));
             return dialog;
         }},
        {QStringLiteral("pairing-refused"),
         [](const Stage &stage) {
             auto *dialog = pairingWith(stage, [](FakePairing &pairing) { Q_EMIT pairing.seen(question("heron")); });
             dialog->findChild<QPushButton *>(QStringLiteral("pairingDiffer"))->click();
             return dialog;
         }},
        {QStringLiteral("pairing-interrupted"),
         [](const Stage &stage) {
             return pairingWith(stage, [](FakePairing &pairing) {
                 Q_EMIT pairing.failed(QStringLiteral("the pairing was interrupted; start again at both ends"));
             });
         }},
        {QStringLiteral("pairing-changed"),
         [](const Stage &stage) {
             return pairingWith(stage, [](FakePairing &pairing) { Q_EMIT pairing.seen(question("scout-1")); });
         }},
        {QStringLiteral("pairing-paired"),
         [](const Stage &stage) {
             return pairingWith(stage, [](FakePairing &pairing) {
                 Q_EMIT pairing.seen(question("heron"));
                 Q_EMIT pairing.paired(QStringLiteral("heron"));
             });
         }},
        {QStringLiteral("link"),
         [](const Stage &stage) -> QWidget * { return new LinkDialog(QStringLiteral("udpin:0.0.0.0:14550"), &stage.window); }},
        {QStringLiteral("settings"),
         [](const Stage &stage) -> QWidget * { return new SettingsDialog(stage.window.settings(), &stage.window); }},
        {QStringLiteral("sweep-dialog"),
         [](const Stage &stage) -> QWidget * {
             auto *sweep = new FakeSweep(&stage.window);
             stage.window.setSweep(*sweep);
             stage.window.findChild<QAction *>(QStringLiteral("actionSweep"))->trigger();
             auto *dialog = stage.window.findChild<SweepDialog *>();
             dialog->findChild<QAbstractButton *>(QStringLiteral("sweepBeside"))->click();
             return dialog;
         }},
        {QStringLiteral("valueseditor"),
         [](const Stage &stage) -> QWidget * {
             ValueChoices choices = defaultValues();
             choices.front().low = 5;
             choices.push_back({.source = *findValueSource(QStringLiteral("BATTERY_STATUS.voltages[2]")), .line = true});
             auto *dialog = new ValuesEditor(choices, UnitSystem::Metric, &stage.window);
             auto *find = dialog->findChild<QLineEdit *>(QStringLiteral("editorFind"));
             find->setText(QStringLiteral("battery volt"));
             return dialog;
         }},
        {QStringLiteral("recordings"), &recordingsOf},
        {QStringLiteral("map-source"),
         [](const Stage &stage) -> QWidget * {
             MapSource source;
             source.kind = MapSource::Kind::Server;
             source.url = QStringLiteral("https://tile.example.org/{z}/{x}/{y}.png");
             source.attribution = QStringLiteral("© Example maps");
             return new MapSourceDialog(source, &stage.window);
         }},
        {QStringLiteral("shortcuts"), [](const Stage &stage) { return byAction<ShortcutDialog>(stage, "actionShortcuts"); }},
        {QStringLiteral("shortcuts-conflict"),
         [](const Stage &stage) {
             QWidget *dialog = byAction<ShortcutDialog>(stage, "actionShortcuts");
             auto *keys = dialog->findChild<ShortcutEdit *>();
             Q_EMIT keys->pressed(QKeySequence(Qt::CTRL | Qt::Key_F9)); // a changed one
             Q_EMIT keys->pressed(QKeySequence(Qt::Key_F12));           // and one of another action
             return dialog;
         }},
        {QStringLiteral("palette"), [](const Stage &stage) { return byAction<CommandPalette>(stage, "actionPalette"); }},
        {QStringLiteral("overlay-list"), [](const Stage &stage) { return byAction<OverlayDialog>(stage, "actionOverlays"); }},
        {QStringLiteral("recordings"), [](const Stage &stage) { return byAction<RecordingsDialog>(stage, "actionReplay"); }},
        {QStringLiteral("region"), [](const Stage &stage) { return byAction<RegionDialog>(stage, "actionFetchArea"); }},
        {QStringLiteral("help"), [](const Stage &stage) { return byAction<HelpDialog>(stage, "actionHelp"); }},
        {QStringLiteral("pre-arm"),
         [](const Stage &stage) -> QWidget * { return new PreArmDialog(commandsOf(stage), &stage.window); }},
        {QStringLiteral("take-off"),
         [](const Stage &stage) -> QWidget * {
             return new TakeOffDialog(commandsOf(stage), UnitSystem::Metric, &stage.window);
         }},
        {QStringLiteral("change-altitude"),
         [](const Stage &stage) -> QWidget * {
             return new ChangeAltitudeDialog(commandsOf(stage), UnitSystem::Metric, 42, &stage.window);
         }},
        {QStringLiteral("add-waypoint"),
         [](const Stage &stage) -> QWidget * {
             return new AddWaypointDialog(commandsOf(stage), UnitSystem::Metric, 47.3979, 8.5461,
                                          QStringLiteral("47.3979000, 8.5461000, 38 m from the vehicle"), &stage.window);
         }},
        {QStringLiteral("peer-new"),
         [](const Stage &stage) -> QWidget * { return new PeerDialog(stage.keyring, &stage.window); }},
        {QStringLiteral("link-mavsec"),
         [](const Stage &stage) -> QWidget * {
             auto *dialog = new LinkDialog(QStringLiteral("udpin:0.0.0.0:14550"), &stage.window);
             auto *protection = dialog->findChild<QComboBox *>(QStringLiteral("linkProtection"));
             protection->setCurrentIndex(1);
             return dialog;
         }},
    };
    return all;
}

} // namespace

QStringList dialogStates()
{
    QStringList out;
    for (const auto &[name, open] : dialogs())
        out.append(name);
    return out;
}

void fillKeyring(FakeKeyring &keyring)
{
    keyring.own = {keyOf(1), true, QStringLiteral("/home/ann/.local/share/skyseal/skyseal/identity.key"), {}};
    keyring.list = {{peerOf("scout-1", 2), peerOf("tablet", 3), peerOf("survey-wing", 4)},
                    QStringLiteral("/home/ann/.local/share/skyseal/skyseal/peers"),
                    {}};
    keyring.list.peers[0].connected = true;
    keyring.list.peers[0].hasPresharedKey = true;
    keyring.list.peers[1].role = channel::PeerRole::Observer;
    keyring.list.peers[1].systems = {1, 2};
    keyring.list.peers[2].lastSeen = {};
}

QWidget *openDialog(const QString &state, MainWindow &window, FakeKeyring &keyring, FakePairing &pairing)
{
    const auto found = dialogs().find(state);
    if (found == dialogs().end())
        return nullptr;
    QWidget *dialog = found->second({window, keyring, pairing});
    dialog->show();
    return dialog;
}

} // namespace skyseal::ui
