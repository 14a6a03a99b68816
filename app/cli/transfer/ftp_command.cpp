// skyseal-cli ftp: the files of a vehicle, by MAVLink FTP.
#include "app/cli/commands.h"
#include "app/cli/transfer/actions.h"
#include "app/cli/transfer/download_task.h"
#include "app/cli/transfer/request_task.h"
#include "app/cli/transfer/transfer_options.h"
#include "app/common/exit_status.h"
#include "app/common/format.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/vehicle/file_transfer.h"

namespace skyseal::app {

namespace {

using vehicle::FileResult;
using FileTask = RequestTask<FileResult>;

constexpr const char *kPathHelp = "Path on the vehicle, e.g. /APM/LOGS/00000001.BIN or @PARAM/param.pck.";

/// The part of a path behind its last slash.
QString nameIn(const QString &path)
{
    return path.section(QLatin1Char('/'), -1);
}

/// Runs the request; `take` prints what came of it.
int runRequest(const QString &program, Options &options, const vehicle::Request &request, const std::string &path,
               const std::function<std::string(const FileResult &, const TaskSettings &)> &take)
{
    return runTransfer(program, options, [&](const TaskSettings &settings) {
        return std::make_shared<FileTask>(
            settings, request, [take, settings](const FileResult &result) { return take(result, settings); }, path + ": ");
    });
}

void printEntry(const vehicle::RemoteFile &file, const TaskSettings &settings)
{
    if (!settings.json) {
        printLine(file.isFolder ? "         - " + file.name + "/" : format("%10u ", file.size) + file.name);
        return;
    }
    JsonWriter out;
    out.beginObject().field("event", "entry").field("name", file.name).field("folder", file.isFolder);
    out.field("size", std::uint64_t(file.size)).endObject();
    printLine(out.text());
}

/// A transfer of a whole file has succeeded.
void reportDone(const TaskSettings &settings, const char *event, const std::string &file, std::size_t bytes, bool verified)
{
    if (!settings.json)
        return remark(file + ": " + counted(bytes, "byte") + (verified ? ", the checksums agree" : ", without a checksum"));
    JsonWriter out;
    out.beginObject().field("event", event).field("file", file).field("bytes", std::uint64_t(bytes));
    out.field("verified", verified).endObject();
    printLine(out.text());
}

int listFolder(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Lists a folder of the vehicle: the size and the name of each file."));
    options.addArgument("[PATH]", "Folder on the vehicle; / without it.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const std::string path = options.arguments(0, 1).value(0, QStringLiteral("/")).toStdString();
    return runRequest(name, options, vehicle::ListFolder{path}, path,
                      [](const FileResult &result, const TaskSettings &settings) {
                          for (const vehicle::RemoteFile &file : *result.entries)
                              printEntry(file, settings);
                          return std::string();
                      });
}

int getFile(const QString &name, const QStringList &arguments)
{
    Options options(name,
                    QStringLiteral("Reads a file of the vehicle and compares the checksums. Until it is "
                                   "complete, it is kept in FILE.part: an interrupted transfer resumes from there."));
    options.addArgument("PATH", kPathHelp);
    options.addArgument("[FILE]", "File to write; an existing one is replaced. Without it, the name in PATH, in this folder.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList given = options.arguments(1, 2);
    const QString path = given.value(0), file = given.value(1, nameIn(path));
    if (file.isEmpty())
        options.fail("'" + path.toStdString() + "' names no file");
    if (const auto status = checkTarget(name, options, file))
        return *status;
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        const std::string remote = path.toStdString();
        DownloadTask<FileResult>::Download download{file.toStdString(), "file " + remote, remote + ": ", {}, {}};
        download.request = [remote](auto kept, auto sink) { return vehicle::ReadFile{remote, kept, sink}; };
        download.take = [file, settings](const FileResult &result) {
            std::string problem = writeWhole(file, asText(*result.content));
            if (problem.empty())
                reportDone(settings, "downloaded", file.toStdString(), result.content->size(), result.verified);
            return problem;
        };
        return std::make_shared<DownloadTask<FileResult>>(settings, std::move(download));
    });
}

int putFile(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Writes a file to the vehicle and compares the checksums."));
    options.addArgument("FILE", "File to read.");
    options.addArgument("PATH", "Path on the vehicle; an existing file is replaced. With a / at its end, the folder for FILE.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList given = options.arguments(2, 2);
    if (const auto status = options.finish())
        return *status;
    const QString folder = given[1].endsWith(QLatin1Char('/')) ? given[1] : QString();
    const std::string path = (folder.isEmpty() ? given[1] : folder + nameIn(given[0])).toStdString();
    const auto content = readWhole(given[0], vehicle::FileTransfer::kMostBytes);
    if (!content) {
        complain(name, content.error());
        return kCannotOpen;
    }
    const auto bytes = std::make_shared<const Bytes>(content->begin(), content->end());
    return runRequest(name, options, vehicle::WriteFile{path, bytes}, path,
                      [bytes, path](const FileResult &result, const TaskSettings &settings) {
                          reportDone(settings, "uploaded", path, bytes->size(), result.verified);
                          return std::string();
                      });
}

int removeFile(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Removes a file of the vehicle."));
    options.addArgument("PATH", kPathHelp);
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const std::string path = options.arguments(1, 1).value(0).toStdString();
    return runRequest(name, options, vehicle::RemoveFile{path}, path, [path](const FileResult &, const TaskSettings &settings) {
        if (!settings.json) {
            remark(path + ": removed");
        } else {
            JsonWriter out;
            out.beginObject().field("event", "removed").field("file", path).endObject();
            printLine(out.text());
        }
        return std::string();
    });
}

} // namespace

int runFtp(const QStringList &arguments)
{
    return runAction(QStringLiteral("ftp"), arguments,
                     {{"ls", listFolder, "list"}, {"get", getFile}, {"put", putFile}, {"rm", removeFile}},
                     "ls [PATH]|get PATH [FILE]|put FILE PATH|rm PATH");
}

} // namespace skyseal::app
