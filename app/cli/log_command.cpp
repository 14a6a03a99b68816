// skyseal-cli log: summary and verification of a recording, and export of its telemetry.
#include "app/cli/commands.h"
#include "app/cli/log_input.h"
#include "app/common/exit_status.h"
#include "app/common/format.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "core/base/number_text.h"
#include "core/base/save_file.h"
#include "core/engine/headless/telemetry_csv.h"
#include "core/log/log_summary.h"

namespace skyseal::app {

namespace {

unsigned long long count(std::uint64_t n)
{
    return n;
}

std::string spotText(const tlog::BadSpot &spot)
{
    return format("offset %llu: %s, ", count(spot.offset), std::string(mavlink::nameOf(spot.fault)).c_str())
        + counted(spot.length, "byte");
}

void printSummary(const tlog::LogSummary &summary)
{
    printLine(counted(summary.bytes, "byte") + ", " + counted(summary.frames, "frame")
              + format(" (%llu signed, %llu of MAVLink 1, %llu of unknown messages)", count(summary.signedFrames),
                       count(summary.version1Frames), count(summary.unknownMessages)));
    if (summary.first && summary.last)
        printLine("from " + tlog::utcText(*summary.first) + " to " + tlog::utcText(*summary.last) + ", "
                  + fixedText(std::chrono::duration<double>(summary.length).count(), 1) + " s recorded");
    for (const auto &[sender, frames] : summary.bySender)
        printLine(format("  system %u component %u: %llu", unsigned(sender.first), unsigned(sender.second), count(frames)));
    for (const auto &[message, frames] : summary.byMessage)
        printLine(format("  %-32s %llu", message.c_str(), count(frames)));
    printLine(counted(summary.badSpots, "bad spot") + " (" + counted(summary.badBytes, "byte") + "), "
              + counted(summary.pauses, "pause") + ", time ran back " + counted(summary.backwardSteps, "time")
              + (summary.forwardSteps ? ", clock set forward " + counted(summary.forwardSteps, "time") : std::string()));
}

void printVerdict(const tlog::LogSummary &summary)
{
    for (const tlog::BadSpot &spot : summary.listedSpots)
        printLine(spotText(spot));
    if (summary.isSound())
        printLine("sound: " + counted(summary.frames, "frame"));
    else
        printLine("damaged: " + counted(summary.badSpots, "bad spot") + ", time runs back "
                  + counted(summary.backwardSteps, "time") + "; " + counted(summary.frames, "good frame"));
}

/// Why there is nothing to show or to verify; nullopt if there are frames.
std::optional<std::string> noFrames(const std::string &file, const tlog::LogSummary &summary)
{
    if (summary.frames > 0)
        return std::nullopt;
    if (summary.bytes == 0)
        return file + ": is empty";
    return file + ": contains no MAVLink frame"
        + (summary.listedSpots.empty() ? std::string() : "; " + spotText(summary.listedSpots.front()));
}

int summarizeFile(const QString &name, const QStringList &arguments, bool verify)
{
    Options options(name,
                    verify
                        ? QStringLiteral("Checks that a recording is intact: complete frames, time stamps that never decrease.")
                        : QStringLiteral("Shows the content of a recording."));
    options.addArgument("FILE", "A .tlog or raw MAVLink bytes; - reads standard input.");
    options.addFlag("json", "One JSON object on stdout.");
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList files = options.arguments(1, 1);
    if (const auto status = options.finish())
        return *status;
    LogInput input;
    if (const auto problem = input.open(files[0])) {
        complain(name, *problem);
        return kCannotOpen;
    }
    const tlog::LogSummary summary = tlog::summarize(input.stream(), mavlink::Dialect::builtin());
    const std::optional<std::string> nothing = noFrames(files[0].toStdString(), summary);
    if (options.has("json")) {
        JsonWriter json;
        json.beginObject().field("event", "log").field("file", files[0].toStdString()).field("sound", summary.isSound());
        tlog::writeSummaryFields(json, summary);
        json.endObject();
        printLine(json.text());
    } else if (!nothing) {
        verify ? printVerdict(summary) : printSummary(summary);
    }
    if (nothing)
        complain(name, *nothing);
    return nothing || (verify && !summary.isSound()) ? kNotReached : kDone;
}

int exportFile(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Writes the telemetry of a .tlog as CSV."));
    options.addArgument("FILE", "A .tlog; - reads standard input.");
    options.addValue("out", "FILE", "Output file; standard output by default.");
    options.addValue("every", "S", "Seconds between two rows of a vehicle; 0 = a row for every frame.", "0.1");
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList files = options.arguments(1, 1);
    const auto every = options.seconds("every", 0, 86400);
    if (const auto status = options.finish())
        return *status;
    LogInput input;
    if (const auto problem = input.open(files[0])) {
        complain(name, *problem);
        return kCannotOpen;
    }
    std::optional<NewFile> file;
    if (const std::string target = options.text("out"); !target.empty()) {
        auto made = NewFile::saving(target);
        if (!made) {
            complain(name, made.error().text());
            return kCannotOpen;
        }
        file.emplace(std::move(*made));
    }
    const std::uint64_t rows = engine::exportTelemetry(
        input.stream(), mavlink::Dialect::builtin(), every,
        [&file](const std::string &line) { return file ? file->write(asBytes(line + '\n')) : printOwnText(line); });
    if (!file && !(flushOutput() && outputError() == 0))
        return kCannotOpen; // finishOutput() says why
    if (const auto saved = file ? file->commit() : Result<void, InputError>(); !saved) {
        complain(name, saved.error().text());
        return kCannotOpen;
    }
    remark(counted(rows, "row"));
    return rows > 0 ? kDone : kNotReached;
}

} // namespace

int runLog(const QStringList &arguments)
{
    const QString action = arguments.value(0);
    const QString name = QStringLiteral("skyseal-cli log");
    if (action == QLatin1String("info"))
        return summarizeFile(name + QStringLiteral(" info"), arguments.mid(1), false);
    if (action == QLatin1String("verify"))
        return summarizeFile(name + QStringLiteral(" verify"), arguments.mid(1), true);
    if (action == QLatin1String("export"))
        return exportFile(name + QStringLiteral(" export"), arguments.mid(1));
    if (action == QLatin1String("--help") || action == QLatin1String("-h")) {
        printOwnText("Usage: skyseal-cli log info|verify|export FILE\nEach command has --help.");
        return kDone;
    }
    complain(name, "info, verify or export is expected");
    return kUsage;
}

} // namespace skyseal::app
