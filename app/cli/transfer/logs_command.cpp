// skyseal-cli logs: the flight logs on a vehicle, by the log protocol.
#include "app/cli/commands.h"
#include "app/cli/transfer/actions.h"
#include "app/cli/transfer/download_task.h"
#include "app/cli/transfer/request_task.h"
#include "app/cli/transfer/transfer_options.h"
#include "app/common/format.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"

#include <QtCore/QDateTime>

namespace skyseal::app {

namespace {

using vehicle::LogResult;
using LogTask = RequestTask<LogResult>;

void printLog(const vehicle::OnboardLog &log, const TaskSettings &settings)
{
    if (!settings.json) {
        const std::string time = log.timeSeconds == 0
            ? "-"
            : QDateTime::fromSecsSinceEpoch(log.timeSeconds, Qt::UTC).toString(Qt::ISODate).toStdString();
        printLine(format("%5u %10u %s", unsigned(log.id), log.size, time.c_str()));
        return;
    }
    JsonWriter out;
    out.beginObject().field("event", "log").field("id", unsigned(log.id)).field("bytes", std::uint64_t(log.size));
    out.field("time", std::uint64_t(log.timeSeconds)).endObject();
    printLine(out.text());
}

int listLogs(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Lists the logs: number, bytes, and the time in UTC if the vehicle knows it."));
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    return runTransfer(name, options, [](const TaskSettings &settings) {
        return std::make_shared<LogTask>(settings, vehicle::ListLogs{}, [settings](const LogResult &result) {
            for (const vehicle::OnboardLog &log : *result.entries)
                printLog(log, settings);
            return std::string();
        });
    });
}

int getLog(const QString &name, const QStringList &arguments)
{
    Options options(name,
                    QStringLiteral("Reads a log. ArduPilot sends logs only while it is disarmed. Until it is "
                                   "complete, it is kept in FILE.part: an interrupted transfer resumes from there."));
    options.addArgument("ID", "Number of the log, as 'logs list' shows it.");
    options.addArgument("[FILE]", "File to write; an existing one is replaced. Without it, log-ID.bin in this folder.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList given = options.arguments(1, 2);
    bool isNumber = false;
    const std::uint16_t log = given.value(0).toUShort(&isNumber);
    if (!isNumber)
        options.fail("'" + given.value(0).toStdString() + "': the number of a log is expected");
    const QString file = given.value(1, QStringLiteral("log-%1.bin").arg(log));
    if (const auto status = checkTarget(name, options, file))
        return *status;
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        const auto save = [settings, file](const LogResult &result) {
            const std::size_t bytes = result.content->size();
            std::string problem = writeWhole(file, asText(*result.content));
            if (!problem.empty())
                return problem;
            if (!settings.json) {
                remark(file.toStdString() + ": " + counted(bytes, "byte"));
            } else {
                JsonWriter out;
                out.beginObject().field("event", "downloaded").field("file", file.toStdString());
                out.field("bytes", std::uint64_t(bytes)).endObject();
                printLine(out.text());
            }
            return problem;
        };
        const std::string subject = "log " + std::to_string(log);
        DownloadTask<LogResult>::Download download{file.toStdString(), subject, subject + ": ", {}, save};
        download.request = [log](auto kept, auto sink) { return vehicle::ReadLog{log, kept, sink}; };
        return std::make_shared<DownloadTask<LogResult>>(settings, std::move(download));
    });
}

int eraseLogs(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Erases all logs of the vehicle, and waits until it lists none."));
    options.addFlag("all", "Required: the vehicle cannot erase a single one. 'ftp rm' removes a single file.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    if (!options.has("all"))
        options.fail("--all is required: the vehicle cannot erase a single log");
    return runTransfer(name, options, [](const TaskSettings &settings) {
        return std::make_shared<LogTask>(settings, vehicle::EraseLogs{}, [settings](const LogResult &) {
            if (settings.json) {
                JsonWriter out;
                out.beginObject().field("event", "erased").endObject();
                printLine(out.text());
            } else {
                remark("erased");
            }
            return std::string();
        });
    });
}

} // namespace

int runLogs(const QStringList &arguments)
{
    return runAction(QStringLiteral("logs"), arguments, {{"list", listLogs}, {"get", getLog}, {"erase", eraseLogs}},
                     "list|get ID [FILE]|erase --all");
}

} // namespace skyseal::app
