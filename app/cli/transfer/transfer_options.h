// The options that all commands for one vehicle share, and their run.
#pragma once

#include "app/cli/transfer/vehicle_task.h"
#include "app/common/options.h"
#include "core/base/research.h"
#include "core/engine/station/station_config.h"

#include <functional>
#include <memory>

namespace skyseal::app {

/// Declares the links, keys and choice of the vehicle.
void declareTransfer(Options &options);
/// Runs the task that `makeTask` builds; returns the exit status. Call it after all other options were read.
int runTransfer(const QString &program, Options &options,
                const std::function<std::shared_ptr<VehicleTask>(const TaskSettings &)> &makeTask);

/// A file of this machine, of at most this many bytes; the error says what is wrong.
Result<std::string, std::string> readWhole(const QString &file, qint64 most = 64 << 20);
/// Replaces the file when all was written; returns what went wrong, or an empty text.
std::string writeWhole(const QString &file, std::string_view content);

} // namespace skyseal::app
