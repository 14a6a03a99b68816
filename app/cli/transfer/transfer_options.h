// The options that all commands for one vehicle share, and their run.
#pragma once

#include "app/cli/transfer/vehicle_task.h"
#include "app/common/options.h"
#include "core/base/research.h"
#include "core/engine/station/station_config.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

namespace skyseal::app {

/// Declares the links, keys and choice of the vehicle.
void declareTransfer(Options &options);
/// Runs the task that `makeTask` builds; returns the exit status. Call it after all other options were read.
int runTransfer(const QString &program, Options &options,
                const std::function<std::shared_ptr<VehicleTask>(const TaskSettings &)> &makeTask);

/// A file of this machine, of at most this many bytes; the error says what is wrong.
Result<std::string, std::string> readWhole(const QString &file, qint64 most = 64 << 20);
/// The same, read by `parse` (content and name of the file → Result). Says what is wrong; then nullopt.
template<typename Parse> auto parseFile(const QString &program, const QString &file, Parse parse)
{
    using Parsed = std::remove_cvref_t<decltype(*parse(std::string(), std::string()))>;
    std::optional<Parsed> out;
    const auto text = readWhole(file);
    if (!text) {
        complain(program, text.error());
        return out;
    }
    auto parsed = parse(*text, file.toStdString());
    if (parsed)
        out = std::move(*parsed);
    else
        complain(program, parsed.error().text());
    return out;
}

/// Replaces the file when all was written; returns what went wrong, or an empty text.
std::string writeWhole(const QString &file, std::string_view content);
/// Before a transfer: an exit status if the usage is wrong, or the file to be written cannot be, which is said.
std::optional<int> checkTarget(const QString &program, const Options &options, const QString &file);
/// A sentence for people, or for machines an event with the number of things of a kind, of a transfer that has succeeded.
void reportTransfer(bool json, const char *event, const char *kind, std::size_t count, const std::string &sentence);

} // namespace skyseal::app
