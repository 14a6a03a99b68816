// skyseal-air: the onboard agent for an autopilot.
#include "app/air/agent_check.h"
#include "app/air/agent_options.h"
#include "app/air/agent_reload.h"
#include "app/air/agent_report.h"
#include "app/air/pair_client.h"
#include "app/air/pairing_server.h"
#include "app/air/signing_command.h"
#include "app/common/exit_status.h"
#include "app/common/journal.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/pairing_passphrase_input.h"
#include "app/common/peers_watch.h"
#include "app/common/process.h"
#include "app/common/service_manager.h"
#include "core/crypto/init_crypto.h"
#include "core/engine/agent/vehicle_key.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/keys/file_io.h"
#include "core/keys/peers_file.h"
#include "core/link/event_loop.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include <utility>

using namespace skyseal;
using namespace skyseal::app;

namespace {

const QString kName = QStringLiteral("skyseal-air");

/// Ends the program when a link can never work as it was written.
bool isHopeless(const engine::AgentEvent &event)
{
    const auto *changed = std::get_if<engine::AgentLinkChanged>(&event);
    return changed && (changed->link.phase == engine::LinkPhase::Failed || changed->link.hostUnknown);
}

/// Options that apply to a pairing only. Rejected elsewhere, since ignoring them silently would mislead the user.
void refusePairingOptions(Options &options)
{
    for (const char *option :
         {"role", "replace", "expect", "as", "fingerprints", "pair-passphrase", "pair-passphrase-file", "pair-passphrase-fd"}) {
        if (options.has(option))
            options.fail(std::string("--") + option + " requires --pair");
    }
}

/// A new agent starts with an empty list, so that a station can be paired. Not without a key: then a path may be mistyped.
bool createMissingList(const engine::KeyPaths &paths)
{
    if (!keys::fileExists(paths.identity))
        return true;
    const auto created = keys::createMissingPeers(paths.peers);
    if (!created)
        complain(kName, created.error().text());
    else if (*created)
        remark(paths.peers + ": created; no station is known yet, pair one with " + kName.toStdString() + " --pair --identity "
               + paths.identity);
    return created.has_value();
}

/// Null without a signing key.
Result<std::unique_ptr<engine::VehicleSigning>, InputError> makeSigning(const SigningSetup &setup)
{
    if (setup.keyFile.empty())
        return nullptr;
    return engine::readVehicleKey(setup.keyFile).map([&setup](engine::VehicleKey &&key) {
        return std::make_unique<engine::VehicleSigning>(std::move(key), setup.acceptUnsigned);
    });
}

/// skyseal-air --pair: a client of the running agent.
int pair(Options &options)
{
    const std::string identity = options.required("identity");
    PairingPrompt::Settings settings = PairingPrompt::read(options);
    if (options.has("role") && !(settings.role = keys::peerRoleFromText(options.text("role"))))
        options.fail("--role '" + options.text("role") + "': pilot or observer is expected");
    const PairingPassphraseInput passphrase = PairingPassphraseInput::read(options);
    for (const char *option : {"vehicle", "ground", "carrier", "peers"}) {
        if (options.has(option) && !options.has("config"))
            options.fail(std::string("--") + option + " is an option of the running agent; --pair needs only its --identity");
    }
    if (const auto status = options.finish())
        return *status;
    if (!crypto::initCrypto()) {
        complain(kName, "the system provides no randomness");
        return kCannotOpen;
    }
    const auto typed = passphrase.passphrase();
    if (!typed) {
        complain(kName, typed.error().text());
        return kCannotOpen;
    }
    return runPairClient(kName, identity, std::move(settings), typed->get());
}

} // namespace

int main(int argc, char **argv)
{
    protectKeysInMemory();
    link::installEventLoop();
    QCoreApplication application(argc, argv);
    Options options(kName, QStringLiteral("Onboard agent that seals the MAVLink link of an autopilot."));
    declareAgent(options);
    const QStringList arguments = application.arguments().mid(1);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    if (options.has("pair"))
        return pair(options);
    if (options.has("signing"))
        return finishOutput(kName, runSigning(options));
    refusePairingOptions(options);
    const std::optional<AgentSetup> setup = readAgent(options);
    if (const auto status = options.finish())
        return *status;
    if (options.has("check"))
        return finishOutput(kName, checkSetup(*setup));
    const engine::KeyPaths &paths = setup->keys;
    if (!crypto::initCrypto()) {
        complain(kName, "the system provides no randomness");
        return kCannotOpen;
    }
    if (!createMissingList(paths))
        return kCannotOpen;
    auto secrets = engine::readSecretFiles(paths);
    if (!secrets) {
        complain(kName, secrets.error().text());
        return kCannotOpen;
    }

    auto signing = makeSigning(setup->signing);
    if (!signing) {
        complain(kName, signing.error().text());
        return kCannotOpen;
    }

    AgentReport report(options.has("json"));
    int status = kDone;
    bool started = false;
    PairingServer *desk = nullptr;
    engine::AgentCore agent(
        setup->config, std::move(*secrets),
        [&](const engine::AgentEvent &event) {
            if (!started && isHopeless(event)) {
                const engine::LinkSnapshot &link = std::get<engine::AgentLinkChanged>(event).link;
                complain(kName, link.url + ": " + link.problem.text());
                status = kCannotOpen;
                QCoreApplication::exit(status);
                return;
            }
            if (const auto *pairing = std::get_if<channel::PairingEvent>(&event); pairing && desk)
                desk->take(*pairing);
            report.notify(event);
        },
        std::move(*signing));
    PairingServer pairings(agent, paths, [&report](const PairingStatus &pairing) { report.pairing(pairing); });
    desk = &pairings;
    if (!pairings.problem().isEmpty())
        remark("no pairing: " + pairings.problem().toStdString(), mavlink::MAV_SEVERITY_WARNING);
    const PeersWatch watch(paths.peers, [&](std::vector<channel::Peer> peers) { agent.setPeers(std::move(peers)); });
    reportPeers(watch, options.has("json"));
    QElapsedTimer clock;
    clock.start();
    const auto elapsed = [&clock] { return static_cast<double>(clock.elapsed()) / 1000; };
    QTimer everySecond;
    ServiceManager manager;
    QObject::connect(&everySecond, &QTimer::timeout, &application, [&] {
        if (!std::exchange(started, true)) // later failures of links are retried
            manager.ready();
        report.stats(agent.snapshot(), elapsed());
    });
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &application, [] { QCoreApplication::exit(kDone); });
    AgentReload reload(arguments, *setup);
    signals.takeReload();
    QObject::connect(&signals, &StopSignals::reloadRequested, &application, [&] {
        if (auto policy = reload.changedPolicy())
            agent.setPolicy(std::move(*policy));
    });
    QTimer::singleShot(0, &application, [&] {
        agent.start();
        everySecond.start(1000);
    });
    const int ended = application.exec();
    manager.stopping();
    agent.stop();
    if (status == kDone)
        report.summary(agent.snapshot(), elapsed());
    return ended;
}
