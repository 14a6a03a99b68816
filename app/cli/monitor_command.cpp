// skyseal-cli monitor: runs a station without a window.
#include "app/cli/commands.h"
#include "app/common/mavsec_options.h"
#include "app/cli/station_options.h"
#include "app/cli/station_run.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/base/research.h"
#include "core/crypto/inline_cipher.h"

#include <algorithm>

namespace skyseal::app {

namespace {

void declareMonitorOptions(Options &options)
{
    options.addLink("link", "Link to vehicles or their agents, e.g. udpin:0.0.0.0:14550. May be given several times.");
    options.addResearchValue("secure", "required|off",
                             "required: accept only sealed vehicles (default with --identity); off: use no sealed links.");
    declareKeys(options);
    options.addResearchFlag("allow-research", "Also accept insecure research suites, for comparison.");
    options.addValue("switch-to", "LIST", "Suites to switch through, repeatedly.");
    options.addValue("switch-every", "S", "Seconds between two switches.", "1");
    options.addResearchValue(
        "framing", "sealed|inline|mavsec2019",
        "Protection of MAVLink. sealed: whole frames in records; inline: frames sealed in place, headers not "
        "encrypted; mavsec2019: INSECURE, receive only, as in the published code of the MAVSec paper.",
        "sealed");
    MavsecOptions::declare(options);
    options.addValue("stream-rate", "HZ", "Request all streams at this rate instead of the default rates.");
    declareDuration(options);
    options.addValue("do", "SCRIPT",
                     "Flight script, see FLIGHT SCRIPTS in the manual page: "
                     "'mode GUIDED; arm; takeoff 10; wait alt_rel>=9.5 60; land; wait armed==0 90'.");
    declareRecording(options);
    options.addFlag("json", "One JSON object per line on stdout.");
}

void readFraming(Options &options, engine::StationConfig &config)
{
    const std::string framing = options.text("framing");
    if (framing == "mavsec2019" && config.secure == engine::SecureMode::Required)
        options.fail("--framing 'mavsec2019' is not sealed: use it with --secure off and without --identity");
    if (framing != "sealed" && framing != "inline" && framing != "mavsec2019")
        options.fail("--framing '" + framing + "': sealed, inline or mavsec2019 is expected");
    if (framing != "inline")
        return;
    if (config.secure != engine::SecureMode::Required)
        return options.fail("--framing 'inline': there is no sealed link; use --secure required");
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
    config.policy.allowResearch = config.secure == engine::SecureMode::Required && options.has("allow-research");
    readKeys(options, config);
    readFraming(options, config);
}

engine::StationConfig readConfig(Options &options)
{
    engine::StationConfig config;
    readSecurity(options, config);
    readRecording(options, config);
    if (options.has("stream-rate"))
        config.streamRate = options.number("stream-rate", 0.1, 1000);
    config.snapshotsPerSecond = 20;
    return config;
}

engine::RunPlan readRunPlan(Options &options, const engine::StationConfig &config)
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
    if (options.has("switch-to")) {
        plan.switchTo = options.suites("switch-to");
        if (options.text("switch-to") == "all" && !config.policy.allowResearch)
            std::erase_if(plan.switchTo, [](crypto::SuiteId suite) { return crypto::suiteInfo(suite).research; });
        for (const crypto::SuiteId suite : plan.switchTo)
            checkSuite(options, config, "switch-to", suite);
    }
    plan.switchEvery = options.seconds("switch-every", 0.01, kLongestRun);
    plan.duration = readDuration(options);
    if (options.has("do")) {
        auto script = vehicle::parseFlightScript(options.text("do"));
        if (script)
            plan.script = std::move(*script);
        else
            options.fail("--do: " + script.error().message.text());
    }
    return plan;
}

} // namespace

int runMonitor(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli monitor");
    Options options(name, QStringLiteral("Monitors vehicles without a display."));
    declareMonitorOptions(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    options.required("link");
    const std::vector<link::LinkUrl> links = options.urls("link");
    const engine::StationConfig config = readConfig(options);
    engine::RunPlan plan = readRunPlan(options, config);
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
    return runStation({name, config, std::move(plan), links, options.has("json")});
}

} // namespace skyseal::app
