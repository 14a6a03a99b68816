// skyseal-cli report: writes the report of a finished sweep again, or one over the sweeps of several machines.
#include "app/cli/commands.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/sweep_files.h"
#include "core/experiment/pooled_report.h"
#include "core/experiment/sweep_reader.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QSet>

#include <algorithm>

namespace skyseal::app {

namespace {

const QString kReportName = QStringLiteral("skyseal-cli report");

Result<experiment::ReadSweep, InputError> readFolder(const QString &folder)
{
    QFile file(QDir(folder).filePath(QStringLiteral("sweep.json")));
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(InputError{file.errorString().toStdString(), file.fileName().toStdString()});
    auto out = experiment::readSweep(file.readAll());
    if (!out)
        return tl::unexpected(InputError{out.error().message, file.fileName().toStdString()});
    return out;
}

/// Their own names, with as many of the folders above as it takes to tell them apart.
std::vector<std::string> labelsOf(const QStringList &folders)
{
    QList<QStringList> paths;
    for (const QString &folder : folders)
        paths << QDir::cleanPath(QDir(folder).absolutePath()).split(QLatin1Char('/'), Qt::SkipEmptyParts);
    QStringList names;
    for (qsizetype depth = 1; depth < 100; ++depth) {
        names.clear();
        for (const QStringList &path : std::as_const(paths))
            names << path.mid(std::max<qsizetype>(path.size() - depth, 0)).join(QLatin1Char('/'));
        if (QSet<QString>(names.begin(), names.end()).size() == names.size())
            break;
    }
    std::vector<std::string> out;
    for (const QString &name : std::as_const(names))
        out.push_back(name.toStdString());
    return out;
}

int finishReport(const SweepFiles &files, const QString &folder)
{
    if (!files.problem.empty())
        complain(kReportName, files.problem.text());
    if (!files.written)
        return kCannotOpen;
    remark("written to " + folder.toStdString());
    return kDone;
}

/// The same files as the sweep itself wrote.
int reportOne(const experiment::ReadSweep &sweep, const QString &folder)
{
    std::vector<experiment::Verdict> verdicts;
    for (const std::string &text : sweep.expectations) {
        const auto parsed = experiment::Expectation::parse(text);
        if (!parsed || !experiment::fits(*parsed, sweep.results.plan))
            continue;
        const auto judged = experiment::judge(*parsed, sweep.results);
        verdicts.insert(verdicts.end(), judged.begin(), judged.end());
    }
    return finishReport(writeSweepFiles(folder, sweep.results, verdicts), folder);
}

} // namespace

int runReport(const QStringList &arguments)
{
    Options options(
        kReportName,
        QStringLiteral("Writes the report of a finished sweep again, or one report over the sweeps of several machines, "
                       "autopilots or days."));
    options.addArgument("DIR", "Folders written by sweep --out, by whose names the report calls the sweeps.");
    options.addValue("out", "DIR", "Folder for the report and its figures.");
    if (const auto status = options.parse(arguments))
        return *status;
    constexpr int kMostMachines = 100;
    const QStringList folders = options.arguments(1, kMostMachines);
    const QString out = QString::fromStdString(options.required("out"));
    if (const auto status = options.finish())
        return *status;
    const std::vector<std::string> labels = labelsOf(folders);
    std::vector<experiment::Machine> machines;
    for (const QString &folder : folders) {
        auto read = readFolder(folder);
        if (!read) {
            complain(kReportName, read.error().text());
            return kCannotOpen;
        }
        if (folders.size() == 1)
            return reportOne(*read, out);
        machines.push_back({labels[machines.size()], read->schemaVersion, std::move(read->results)});
    }
    if (const std::string mismatch = experiment::mismatchOf(machines); !mismatch.empty()) {
        complain(kReportName, mismatch);
        return kNotReached;
    }
    return finishReport(writePooledFiles(out, machines), out);
}

} // namespace skyseal::app
