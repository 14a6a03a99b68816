// skyseal-air: the onboard agent for an autopilot.
#include "app/air/agent_report.h"
#include "app/air/pair_client.h"
#include "app/air/pairing_server.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/pairing_passphrase_input.h"
#include "app/common/peers_watch.h"
#include "app/common/process.h"
#include "core/channel/policy.h"
#include "core/channel/suite_strength.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/file_io.h"
#include "core/keys/peers_file.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QElapsedTimer>
#include <QtCore/QTimer>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::app;

namespace {

const QString kName = QStringLiteral("skyseal-air");

/// The agent sends the first message, so it needs a remote end, or a byte stream that a station opens.
bool leadsToStation(const link::LinkTraits &traits)
{
    return !traits.isRecording && !traits.isDatagramServer();
}

void declare(Options &options)
{
    options.addLink("vehicle",
                    "Plain MAVLink link to the autopilot, e.g. serial:/dev/ttyAMA0:921600, udpin:14551 or "
                    "tcp:127.0.0.1:5760. A listening link without a host listens on 127.0.0.1: any program that reaches that "
                    "port can control the vehicle.");
    options.addLink("ground", "Sealed link to the ground station; the agent announces itself there.", leadsToStation);
    options.addValue("carrier", "datagram|serial|tunnel",
                     "How sealed records travel on the ground link: one per datagram; in COBS frames, on a byte stream that "
                     "only the two ends share; or in MAVLink TUNNEL messages, through MAVLink routers and radios (any link). "
                     "Default: datagram or serial, depending on the link. The station detects the carrier.");
    options.addValue("identity", "FILE", "Private key of this agent (skyseal-cli keys new).");
    PassphraseInput::declare(options);
    options.addValue("peers", "FILE", "Ground stations that may connect; created if missing.");
    options.addValue("suites", "LIST", "Suites to offer, separated by commas, the preferred one first.", "all");
    options.addValue("weakest-suite", "NAME", "Use no suite that is weaker than this one.",
                     crypto::suiteInfo(crypto::weakestSealedSuite()).name.data());
    options.addResearchFlag("allow-research", "Also accept insecure research suites, for comparison.");
    options.addResearchFlag(
        "allow-plain",
        "Forward plain MAVLink while no session is up; anyone can read and forge it. For baseline measurements.");
    options.addResearchFlag("allow-inline",
                            "Also seal frames in place if the station asks for it: headers are not encrypted, tags are short.");
    options.addValue(
        "max-overtaken", "SECONDS",
        "Obey no command that a newer message overtook longer ago than this: it was withheld on its way. 0.2 to 10.", "1");
    options.addValue("max-age", "SECONDS|off",
                     "Obey no command that may be older than this. The agent can only bound the age, by the round trip of the "
                     "link and the time since: choose more than twice the longest delay. 0.5 to 60.",
                     "5");
    options.addFlag("pair",
                    "Open the pairing window of the agent that runs with this --identity, and confirm the station there.");
    options.addValue(
        "role", "pilot|observer",
        "With --pair: role of the station. Without it a known station keeps its role, and you choose that of a new "
        "one; with --expect it becomes an observer.");
    PairingPrompt::declare(options); // with --json
    PairingPassphraseInput::declare(options);
}

/// The carrier of the option, or the default of the link.
Carrier readCarrier(Options &options, const std::optional<link::LinkUrl> &ground)
{
    if (!ground)
        return {};
    const bool datagrams = !ground->traits().isStream;
    const std::string asked = options.has("carrier") ? options.text("carrier") : datagrams ? "datagram" : "serial";
    if (asked == "tunnel")
        return Carrier::Tunnel;
    if (asked != "datagram" && asked != "serial")
        options.fail("--carrier '" + asked + "': datagram, serial or tunnel is expected");
    else if (asked == "datagram" && !datagrams)
        options.fail("--carrier 'datagram': " + ground->toText() + " is a byte stream; use serial or tunnel");
    else if (asked == "serial" && datagrams)
        options.fail("--carrier 'serial': " + ground->toText() + " carries datagrams; use datagram or tunnel");
    return asked == "serial" ? Carrier::Serial : Carrier::Datagram;
}

channel::FreshnessLimits readFreshness(Options &options)
{
    using Limits = channel::FreshnessLimits;
    const auto duration = [](double value) {
        return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(value));
    };
    Limits out;
    out.overtaken = duration(
        options.number("max-overtaken", seconds(Limits::kLeastOvertaken), seconds(Limits::kMostOvertaken)));
    out.age.reset();
    if (options.text("max-age") != "off")
        out.age = duration(options.number("max-age", seconds(Limits::kLeastAge), seconds(Limits::kMostAge)));
    return out;
}

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

/// skyseal-air --pair: a client of the running agent.
int pair(Options &options)
{
    const std::string identity = options.required("identity");
    PairingPrompt::Settings settings = PairingPrompt::read(options);
    if (options.has("role") && !(settings.role = keys::peerRoleFromText(options.text("role"))))
        options.fail("--role '" + options.text("role") + "': pilot or observer is expected");
    const PairingPassphraseInput passphrase = PairingPassphraseInput::read(options);
    for (const char *option : {"vehicle", "ground", "carrier", "peers"}) {
        if (options.has(option))
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
    QCoreApplication application(argc, argv);
    Options options(kName, QStringLiteral("Onboard agent that seals the MAVLink link of an autopilot."));
    declare(options);
    if (const auto status = options.parse(application.arguments().mid(1)))
        return *status;
    options.arguments(0, 0);
    if (options.has("pair"))
        return pair(options);
    refusePairingOptions(options);
    const auto vehicle = options.url("vehicle", link::LinkUrl::kLoopback);
    const auto ground = options.url("ground");
    const engine::KeyPaths paths{options.required("identity"), options.required("peers"), PassphraseInput::read(options).ask()};
    channel::Policy policy{options.suites("suites"), options.has("allow-research"), options.has("allow-plain")};
    if (const auto weakest = options.suite("weakest-suite"))
        policy.suites = channel::notWeakerThan(*weakest, policy.suites);
    policy.allowInline = options.has("allow-inline");
    const Carrier carrier = readCarrier(options, ground);
    const channel::FreshnessLimits freshness = readFreshness(options);
    const auto isSecure = [](crypto::SuiteId suite) {
        return !crypto::suiteInfo(suite).research && suite != crypto::SuiteId::None;
    };
    if (std::none_of(policy.suites.begin(), policy.suites.end(), isSecure))
        options.fail("--suites: a session begins with a secure suite, so the list must contain one");
    if (const auto status = options.finish())
        return *status;
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

    AgentReport report(options.has("json"));
    int status = kDone;
    bool started = false;
    PairingServer *desk = nullptr;
    engine::AgentConfig config{*vehicle, *ground, std::move(policy), options.has("allow-plain"), carrier, freshness};
    engine::AgentCore agent(std::move(config), std::move(*secrets), [&](const engine::AgentEvent &event) {
        if (!started && isHopeless(event)) {
            const engine::LinkSnapshot &link = std::get<engine::AgentLinkChanged>(event).link;
            complain(kName, link.url + ": " + link.problem);
            status = kCannotOpen;
            QCoreApplication::exit(status);
            return;
        }
        if (const auto *pairing = std::get_if<channel::PairingEvent>(&event); pairing && desk)
            desk->take(*pairing);
        report.notify(event);
    });
    PairingServer pairings(agent, paths, [&report](const PairingStatus &pairing) { report.pairing(pairing); });
    desk = &pairings;
    if (!pairings.problem().isEmpty())
        remark("no pairing: " + pairings.problem().toStdString());
    const PeersWatch watch(paths.peers, [&](std::vector<channel::Peer> peers) { agent.setPeers(std::move(peers)); });
    tellPeers(watch, options.has("json"));
    QElapsedTimer clock;
    clock.start();
    const auto elapsed = [&clock] { return static_cast<double>(clock.elapsed()) / 1000; };
    QTimer everySecond;
    QObject::connect(&everySecond, &QTimer::timeout, &application, [&] {
        started = true; // later failures of links are retried
        report.stats(agent.snapshot(), elapsed());
    });
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &application, [] { QCoreApplication::exit(kDone); });
    QTimer::singleShot(0, &application, [&] {
        agent.start();
        everySecond.start(1000);
    });
    const int ended = application.exec();
    agent.stop();
    if (status == kDone)
        report.summary(agent.snapshot(), elapsed());
    return ended;
}
