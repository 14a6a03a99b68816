// The options that all commands with a station have: keys, suites, recording, duration.
#pragma once

#include "app/common/options.h"
#include "core/engine/station/station_config.h"

#include <optional>

namespace skyseal::app {

/// --identity, its passphrase, --peers, --suite and --weakest-suite.
void declareKeys(Options &options);
/// Reads the keys and suites of a station whose `secure` and policy.allowResearch are set.
void readKeys(Options &options, engine::StationConfig &config);
/// Rejects a suite that would be refused at run time before anything starts. `option`: the one that names it.
void checkSuite(Options &options, const engine::StationConfig &config, const char *option, crypto::SuiteId suite);

/// --record and --no-record.
void declareRecording(Options &options);
void readRecording(Options &options, engine::StationConfig &config);

/// The greatest number of seconds that an option for a time within a run accepts.
inline constexpr double kLongestRun = 1e9;
/// --duration
void declareDuration(Options &options);
/// nullopt without --duration: until the program is stopped.
std::optional<Duration> readDuration(Options &options);

} // namespace skyseal::app
