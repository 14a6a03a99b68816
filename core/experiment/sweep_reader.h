// Reads sweep.json, also of older versions, for reports over finished sweeps, and the runs that a sweep in another process
// prints. The content is not trusted: whatever does not fit the plan that it states is an error in words.
#pragma once

#include "core/base/result.h"
#include "core/experiment/results.h"

#include <QtCore/QByteArray>
#include <QtCore/QJsonObject>

#include <optional>
#include <string>
#include <vector>

namespace skyseal::experiment {

struct ReadSweep
{
    unsigned schemaVersion = 0;
    Results results;
    std::vector<std::string> expectations; ///< texts, each once, in their order
};

/// Every version that was ever written can be read; Results::unknown says what an older one does not hold.
inline constexpr unsigned kOldestReadableSweep = 1;

Result<ReadSweep, InputError> readSweep(const QByteArray &json);

/// The run that the event "begin" names; nullopt if it does not fit the plan.
std::optional<Run> readRun(const QJsonObject &object, const Plan &plan);
/// A run as sweep.json and the event "run" have it; nullopt if it does not fit the plan.
std::optional<Sample> readSample(const QJsonObject &object, const Plan &plan);

} // namespace skyseal::experiment
