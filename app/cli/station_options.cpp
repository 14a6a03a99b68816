#include "app/cli/station_options.h"

#include "app/common/passphrase_input.h"
#include "core/channel/suite_strength.h"

#include <QtCore/QStandardPaths>

#include <algorithm>

namespace skyseal::app {

namespace {

std::string defaultLogFolder()
{
    return (QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/skyseal/logs"))
        .toStdString();
}

} // namespace

void declareKeys(Options &options)
{
    options.addValue("identity", "FILE", "Private key of this station.");
    PassphraseInput::declare(options);
    options.addValue("peers", "FILE", "File of known peers, the agents of the vehicles.");
    options.addValue("suite", "NAME", "Suite at the start of each session.");
    options.addValue("weakest-suite", "NAME", "Use no suite that is weaker than this one.",
                     crypto::suiteInfo(crypto::weakestSealedSuite()).name.data());
}

void readKeys(Options &options, engine::StationConfig &config)
{
    if (config.secure == engine::SecureMode::Required) {
        config.keys = {options.required("identity"), options.required("peers"), PassphraseInput::read(options).ask()};
        config.policy.suites = channel::defaultSuites();
        if (const auto weakest = options.suite("weakest-suite"))
            config.policy.suites = channel::notWeakerThan(*weakest, config.policy.suites);
    }
    if (options.has("suite") && (config.preferredSuite = options.suite("suite")))
        checkSuite(options, config, "suite", *config.preferredSuite);
}

void checkSuite(Options &options, const engine::StationConfig &config, const char *option, crypto::SuiteId suite)
{
    const crypto::SuiteInfo &info = crypto::suiteInfo(suite);
    const std::string what = std::string("--") + option + " '" + std::string(info.name) + "': ";
    if (config.secure != engine::SecureMode::Required)
        options.fail(what + "there is no sealed link; use --secure required");
    else if (!info.authenticated)
        options.fail(what + "plain MAVLink is not a suite of a sealed link");
    else if (info.research && !config.policy.allowResearch)
        options.fail(what + "insecure, for research only; requires --allow-research");
    else if (std::find(config.policy.suites.begin(), config.policy.suites.end(), suite) == config.policy.suites.end())
        options.fail(what + "weaker than --weakest-suite permits");
}

void declareRecording(Options &options)
{
    options.addValue("record", "FOLDER", "Folder of the .tlog files. Default: skyseal/logs in the data folder of the user.");
    options.addFlag("no-record", "Do not write .tlog files.");
    options.addAlternatives("record", "no-record");
}

void readRecording(Options &options, engine::StationConfig &config)
{
    if (options.has("record") && options.has("no-record"))
        options.fail("--record and --no-record exclude each other");
    config.record = !options.has("no-record");
    config.recordFolder = options.has("record") ? options.required("record") : defaultLogFolder();
}

void declareDuration(Options &options)
{
    options.addValue("duration", "S", "Exit after this many seconds.");
}

std::optional<Duration> readDuration(Options &options)
{
    if (!options.has("duration"))
        return std::nullopt;
    return options.seconds("duration", 0, kLongestRun);
}

} // namespace skyseal::app
