// skyseal-cli keys pair: the station's side of a pairing, at a terminal.
#include "app/cli/keys/keys_subcommands.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/pairing_passphrase_input.h"
#include "app/common/pairing_prompt.h"
#include "app/common/process.h"
#include "core/engine/station/station.h"
#include "core/keys/paired_peer.h"
#include "core/keys/peers_file.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QSysInfo>
#include <QtCore/QTimer>

namespace skyseal::app {

namespace {

/// The time for which a pairing repeats its last message, which the peer may have missed.
constexpr std::chrono::milliseconds kLastText{3000};

/// The user's decision, kept until the other end has confirmed as well.
struct Decision
{
    std::string name;
    bool replace = false;
};

PairingStatus keep(const std::string &peersFile, channel::Peer peer, const Decision &decision)
{
    // The peer is an agent; the role matters only for stations.
    peer.name = keys::fitPeerName(decision.name.empty() ? peer.name : decision.name, peer.key);
    peer.role = channel::PeerRole::Pilot;
    const auto kept = keys::keepPairedPeer(
        peersFile, peer, decision.replace ? keys::KeyChange::Accepted : keys::KeyChange::Refused, keys::SharedIds::Refused);
    PairingStatus status;
    status.state = kept ? PairingStatus::State::Paired : PairingStatus::State::Refused;
    status.name = kept ? peer.name : std::string();
    status.key = peer.key;
    status.reason = kept ? std::string() : kept.error().text();
    return status;
}

} // namespace

int pairWithAgent(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli keys pair");
    Options options(name,
                    QStringLiteral("Pairs this station with an agent whose pairing window is open (skyseal-air --pair). Both "
                                   "users compare a code of six digits and confirm."));
    options.addLink("link", "Link to the agent.", isLive, "udpin:0.0.0.0:14550");
    options.addValue("identity", "FILE", "Private key of this station.");
    PassphraseInput::declare(options);
    options.addValue("peers", "FILE", "File of known peers that the agent is added to; created if missing.");
    PairingPrompt::declare(options);
    PairingPassphraseInput::declare(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    const auto url = options.url("link");
    engine::StationConfig config;
    config.secure = engine::SecureMode::Required;
    config.record = false;
    config.policy.suites = channel::defaultSuites();
    config.keys = {options.required("identity"), options.required("peers"), PassphraseInput::read(options).ask()};
    PairingPrompt::Settings settings = PairingPrompt::read(options);
    const PairingPassphraseInput passphrase = PairingPassphraseInput::read(options);
    if (const auto status = options.finish())
        return *status;

    const auto typed = passphrase.passphrase();
    if (!typed) {
        complain(name, typed.error().text());
        return kCannotOpen;
    }
    const std::string peersFile = config.keys.peers;
    if (const auto created = keys::createMissingPeers(peersFile); !created) {
        complain(name, created.error().text());
        return kCannotOpen;
    }
    auto station = engine::Station::create(config);
    if (!station) {
        complain(name, station.error().text());
        return kCannotOpen;
    }
    engine::Station &engine = **station;
    settings.hasPassphrase = *typed != nullptr;
    const std::string callIt = settings.callIt;
    PairingPrompt prompt(std::move(settings));
    Decision decision;
    QObject::connect(&engine, &engine::Station::pairing, &prompt, [&](const channel::PairingEvent &event) {
        if (const auto *paired = std::get_if<channel::Paired>(&event)) {
            prompt.take(keep(peersFile, paired->peer, decision));
            return;
        }
        const auto known = keys::PeersFile::loadOrEmpty(peersFile);
        if (auto status = statusOf(event, known ? *known : keys::PeersFile(), callIt))
            prompt.take(std::move(*status));
    });
    QObject::connect(&engine, &engine::Station::eventOccurred, &prompt, [&](const engine::Event &event) {
        const auto *changed = std::get_if<engine::LinkChanged>(&event);
        if (changed && (changed->link.phase == engine::LinkPhase::Failed || changed->link.addressInUse)) {
            complain(name, changed->link.url + ": " + changed->link.problem.text());
            QCoreApplication::exit(kCannotOpen);
        }
    });
    QObject::connect(&prompt, &PairingPrompt::confirmed, &engine, [&](const PairingPrompt::Answer &answer) {
        decision = {answer.name, answer.replace};
        engine.confirmPairing(answer.key);
    });
    QObject::connect(&prompt, &PairingPrompt::refused, &engine, [&] { engine.refusePairing(); });
    QObject::connect(&prompt, &PairingPrompt::cancelled, &engine, [&] { engine.cancelPairing(); });
    // The last messages must reach the agent before the program exits.
    QObject::connect(&prompt, &PairingPrompt::finished, &engine, [&](int status) {
        QObject::connect(&engine, &engine::Station::stopped, &engine, [status] { QCoreApplication::exit(status); });
        QTimer::singleShot(status == kDone ? kLastText : std::chrono::milliseconds(0), &engine, [&] { engine.stop(); });
    });
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &engine, [&] { engine.cancelPairing(); });
    engine.addLink(*url);
    engine.openPairing(QSysInfo::machineHostName().toStdString(), *typed);
    PairingStatus open;
    open.state = PairingStatus::State::Open;
    open.key = *engine.publicKey();
    open.seconds = static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(channel::kPairingWindow).count());
    prompt.take(open);
    return QCoreApplication::exec();
}

} // namespace skyseal::app
