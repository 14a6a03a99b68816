// The options that all commands with a station have: keys, suites, recording.
#pragma once

#include "app/common/options.h"
#include "core/engine/station/station_config.h"

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

} // namespace skyseal::app
