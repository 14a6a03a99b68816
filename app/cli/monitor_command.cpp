// skyseal-cli monitor: runs a station without a window.
#include "app/cli/commands.h"
#include "app/cli/json_report.h"
#include "app/cli/mavsec_options.h"
#include "app/cli/people_report.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/passphrase_input.h"
#include "app/common/peers_watch.h"
#include "app/common/process.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/base/research.h"
#include "core/channel/suite_strength.h"
#include "core/crypto/inline_cipher.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QStandardPaths>

#include <algorithm>

namespace skyseal::app {

namespace {

constexpr double kLongestRun = 1e9;

void declare(Options &options)
{
    options.addLink("link", "Link to vehicles or their agents, e.g. udpin:0.0.0.0:14550. May be given several times.");
    options.addResearchValue("secure", "required|off",
                             "required: accept only sealed vehicles (default with --identity); off: no sealed links.");
    options.addValue("identity", "FILE", "Private key of this station.");
    PassphraseInput::declare(options);
    options.addValue("peers", "FILE", "File of known peers: the agents of the vehicles.");
    options.addValue("suite", "NAME", "Suite at the start of every session.");
    options.addValue("weakest-suite", "NAME", "Use no suite that is weaker than this one.",
                     crypto::suiteInfo(crypto::weakestSealedSuite()).name.data());
    options.addResearchFlag("allow-research", "Also accept insecure research suites, for comparison.");
    options.addValue("switch-to", "LIST", "Suites to switch through, repeatedly.");
    options.addValue("switch-every", "S", "Seconds between two switches.", "1");
    options.addResearchValue(
        "framing", "sealed|inline|mavsec2019",
        "Protection of MAVLink. sealed: whole frames in records; inline: frames sealed in place, headers not "
        "encrypted; mavsec2019: INSECURE, read-only, as in the published code of the MAVSec paper.",
        "sealed");
    MavsecOptions::declare(options);
    options.addValue("stream-rate", "HZ", "Request every stream at this rate instead of the default profile.");
    options.addValue("duration", "S", "Exit after this many seconds.");
    options.addValue("do", "SCRIPT", "A flight: 'mode GUIDED; arm; takeoff 10; wait alt_rel>=9.5 60; land; wait armed==0 90'.");
    options.addValue("record", "FOLDER", "Folder of the .tlog files.");
    options.addFlag("no-record", "Write no .tlog.");
    options.addFlag("json", "One JSON object per line on stdout.");
}

std::string defaultLogFolder()
{
    return (QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/skyseal/logs"))
        .toStdString();
}

/// Rejects a suite that would be refused at run time before anything starts.
void checkSuite(Options &options, const engine::StationConfig &config, const char *option, crypto::SuiteId suite)
{
    const crypto::SuiteInfo &info = crypto::suiteInfo(suite);
    const std::string what = std::string("--") + option + " '" + std::string(info.name) + "': ";
    if (config.secure != engine::SecureMode::Required)
        options.fail(what + "there is no sealed link; --secure required");
    else if (!info.authenticated)
        options.fail(what + "a sealed link has no plain suite");
    else if (info.research && !config.policy.allowResearch)
        options.fail(what + "insecure, for research only; --allow-research");
    else if (std::find(config.policy.suites.begin(), config.policy.suites.end(), suite) == config.policy.suites.end())
        options.fail(what + "weaker than --weakest-suite allows");
}

void readFraming(Options &options, engine::StationConfig &config)
{
    const std::string framing = options.text("framing");
    if (framing == "mavsec2019" && config.secure == engine::SecureMode::Required)
        options.fail("--framing 'mavsec2019': it is not sealed; use it with --secure off and without --identity");
    if (framing != "sealed" && framing != "inline" && framing != "mavsec2019")
        options.fail("--framing '" + framing + "': sealed, inline or mavsec2019 is expected");
    if (framing != "inline")
        return;
    if (config.secure != engine::SecureMode::Required)
        return options.fail("--framing 'inline': there is no sealed link; --secure required");
    config.policy.allowInline = config.policy.preferInline = true;
    // The session must start with a suite that supports the framing.
    std::stable_partition(config.policy.suites.begin(), config.policy.suites.end(), crypto::mayBeInline);
}

void readSecurity(Options &options, engine::StationConfig &config)
{
    const bool hasKeys = options.has("identity");
    const std::string secure = options.has("secure") ? options.text("secure") : hasKeys || !kResearch ? "required" : "off";
    if (secure != "required" && secure != "off")
        options.fail("--secure '" + secure + "': required or off is expected");
    config.secure = secure == "required" ? engine::SecureMode::Required : engine::SecureMode::Off;
    if (config.secure == engine::SecureMode::Required) {
        config.keys = {options.required("identity"), options.required("peers"), PassphraseInput::read(options).ask()};
        config.policy.suites = channel::defaultSuites();
        if (const auto weakest = options.suite("weakest-suite"))
            config.policy.suites = channel::notWeakerThan(*weakest, config.policy.suites);
        config.policy.allowResearch = options.has("allow-research");
    }
    if (options.has("suite") && (config.preferredSuite = options.suite("suite")))
        checkSuite(options, config, "suite", *config.preferredSuite);
    readFraming(options, config);
}

engine::StationConfig readConfig(Options &options)
{
    engine::StationConfig config;
    readSecurity(options, config);
    config.record = !options.has("no-record");
    config.recordFolder = options.has("record") ? options.text("record") : defaultLogFolder();
    if (options.has("stream-rate"))
        config.streamRate = options.number("stream-rate", 0.1, 1000);
    config.snapshotsPerSecond = 20;
    return config;
}

engine::RunPlan readPlan(Options &options, const engine::StationConfig &config)
{
    engine::RunPlan plan;
    if (options.text("framing") == "mavsec2019") {
        for (const char *sends : {"do", "stream-rate"}) {
            if (options.has(sends))
                options.fail(std::string("--") + sends + ": not with --framing mavsec2019, which never sends");
        }
    }
    plan.inlineRequired = config.policy.preferInline;
    plan.sessionRequired = config.secure == engine::SecureMode::Required;
    const auto inSeconds = [](double s) { return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s)); };
    if (options.has("switch-to")) {
        plan.switchTo = options.suites("switch-to");
        if (options.text("switch-to") == "all" && !config.policy.allowResearch)
            std::erase_if(plan.switchTo, [](crypto::SuiteId suite) { return crypto::suiteInfo(suite).research; });
        for (const crypto::SuiteId suite : plan.switchTo)
            checkSuite(options, config, "switch-to", suite);
    }
    plan.switchEvery = inSeconds(options.number("switch-every", 0.01, kLongestRun));
    if (options.has("duration"))
        plan.duration = inSeconds(options.number("duration", 0, kLongestRun));
    if (options.has("do")) {
        auto script = vehicle::parseFlightScript(options.text("do"));
        if (script)
            plan.script = std::move(*script);
        else
            options.fail("--do: " + script.error().message);
    }
    return plan;
}

int exitStatus(engine::RunOutcome outcome)
{
    switch (outcome) {
    case engine::RunOutcome::Reached: return kDone;
    case engine::RunOutcome::CannotOpen: return kCannotOpen;
    default: return kNotReached;
    }
}

} // namespace

int runMonitor(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli monitor");
    Options options(name, QStringLiteral("Monitors vehicles without a display."));
    declare(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    options.required("link");
    const std::vector<link::LinkUrl> links = options.urls("link");
    const engine::StationConfig config = readConfig(options);
    engine::RunPlan plan = readPlan(options, config);
    const MavsecOptions mavsec = MavsecOptions::read(options);
    if (const auto status = options.finish())
        return *status;

    if (mavsec.isChosen()) {
        auto cipher = mavsec.cipher();
        if (!cipher) {
            complain(name, cipher.error().text());
            return kCannotOpen;
        }
        plan.mavsec = std::make_shared<const crypto::MavsecCipher>(std::move(*cipher));
        complain(name, "INSECURE: anyone can read, change and forge frames that are encrypted as in MAVSec's code");
    }
    auto station = engine::Station::create(config);
    if (!station) {
        complain(name, station.error().text());
        return kCannotOpen;
    }
    std::unique_ptr<engine::RunListener> report;
    if (options.has("json"))
        report = std::make_unique<JsonReport>();
    else
        report = std::make_unique<PeopleReport>(config.record ? config.recordFolder : std::string());
    engine::HeadlessRun run(**station, *report, std::move(plan), links);
    std::optional<PeersWatch> watch;
    if (config.secure == engine::SecureMode::Required) {
        watch.emplace(config.keys.peers, [&](std::vector<channel::Peer> peers) { (*station)->setPeers(std::move(peers)); });
        tellPeers(*watch, options.has("json"));
    }
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &run, &engine::HeadlessRun::stop);
    QObject::connect(&run, &engine::HeadlessRun::finished, qApp, [&](engine::RunOutcome outcome, const std::string &problem) {
        if (outcome != engine::RunOutcome::Reached)
            complain(name, problem);
        QCoreApplication::exit(exitStatus(outcome));
    });
    QMetaObject::invokeMethod(&run, &engine::HeadlessRun::start, Qt::QueuedConnection);
    return QCoreApplication::exec();
}

} // namespace skyseal::app
