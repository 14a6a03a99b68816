#include "app/common/sweep_files.h"

#include "core/base/save_file.h"
#include "core/experiment/cipher_bench.h"
#include "core/experiment/html_report.h"
#include "core/experiment/claims_csv.h"
#include "core/experiment/sweep_csv.h"
#include "core/experiment/sweep_json.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtCore/QStandardPaths>

#include <algorithm>

namespace skyseal::app {

namespace {

constexpr int kDrawingMs = 120000;

/// Returns what went wrong, empty on success.
Reason write(const QString &path, const std::string &content)
{
    const auto saved = saveFile(path.toStdString(), asBytes(content));
    return saved ? Reason() : saved.error().reason();
}

/// Draws PNG and PDF by skyseal-figures. Returns what went wrong, empty on success.
/// `date`: of the PDF.
Reason draw(const QDir &folder, const QStringList &figures, const std::string &report, const std::string &date)
{
    const QString program = programPath(QStringLiteral("skyseal-figures"));
    if (program.isEmpty())
        return sentence(
            "Reason", "no PNG and PDF: skyseal-figures is not installed; report.html and the SVG files have the same content");
    const QString printable = folder.filePath(QStringLiteral("report-print.html"));
    if (Reason problem = write(printable, report); !problem.empty())
        return problem;
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(program,
                  QStringList{QStringLiteral("--report"), printable, QStringLiteral("--pdf"),
                              folder.filePath(QStringLiteral("report.pdf"))}
                      + (date.empty() ? QStringList() : QStringList{QStringLiteral("--date"), QString::fromStdString(date)})
                      + figures);
    const bool drawn = process.waitForFinished(kDrawingMs) && process.exitStatus() == QProcess::NormalExit
        && process.exitCode() == 0;
    QFile::remove(printable);
    return drawn ? Reason() : sentence("Reason", "PNG and PDF could not be drawn by %1")(program.toStdString());
}

/// True if the folder contains the files of an older sweep.
bool holdsSweep(const QDir &folder)
{
    QFile file(folder.filePath(QStringLiteral("sweep.json")));
    return file.open(QIODevice::ReadOnly)
        && QJsonDocument::fromJson(file.readAll()).object()[QLatin1String("schema")] == QLatin1String("skyseal-sweep");
}

/// "packets-natural" and "ratio-packets-natural", with the suffix "-2" and so on if there are several conditions; see
/// experiment::figuresOf().
bool isFigureName(const QString &name)
{
    QStringList parts = name.split(QLatin1Char('-'));
    if (parts.size() > 2 && parts.first() == QLatin1String("ratio"))
        parts.removeFirst();
    return (parts.size() == 2 || (parts.size() == 3 && parts[2].toUInt() > 0))
        && experiment::metricFromKey(parts[0].toStdString()) && experiment::loadFromName(parts[1].toStdString());
}

/// Removes the pictures of an older sweep, which would be taken for those of this one. Other files stay.
void removePictures(const QDir &folder)
{
    if (!holdsSweep(folder))
        return;
    QDir figures(folder.filePath(QStringLiteral("figures")));
    for (const QFileInfo &file :
         figures.entryInfoList({QStringLiteral("*.svg"), QStringLiteral("*.png"), QStringLiteral("*.pdf")}, QDir::Files)) {
        if (isFigureName(file.completeBaseName()))
            figures.remove(file.fileName());
    }
    QFile::remove(folder.filePath(QStringLiteral("report.pdf")));
}

} // namespace

QString programPath(const QString &name)
{
    const QString beside = QCoreApplication::applicationDirPath() + QLatin1Char('/') + name;
    return QFileInfo(beside).isExecutable() ? beside : QStandardPaths::findExecutable(name);
}

std::map<crypto::SuiteId, double> contextSizes(experiment::HeapFigures &heap)
{
    std::map<crypto::SuiteId, double> out;
    for (const crypto::SuiteInfo &suite : crypto::suites()) {
        if (const auto bytes = heap.context(suite.id))
            out[suite.id] = *bytes;
    }
    return out;
}

SweepFiles writeSweepFiles(const QString &path, const experiment::Results &results,
                           const std::vector<experiment::Verdict> &verdicts)
{
    const QDir folder(path);
    const std::vector<experiment::Claim> claims = experiment::paperClaims(results);
    const std::vector<experiment::ReportFigure> figures = experiment::figuresOf(results);
    const experiment::ReportParts parts{results, figures, verdicts, claims};
    std::vector<std::pair<QString, std::string>> files{
        {QStringLiteral("sweep.json"), experiment::sweepJson(results, verdicts) + "\n"},
        {QStringLiteral("sweep.csv"), experiment::sweepCsv(results)},
        {QStringLiteral("sweep-columns.csv"), experiment::sweepColumnsCsv()},
        {QStringLiteral("ratios.csv"), experiment::ratiosCsv(results)},
        {QStringLiteral("ratios-columns.csv"), experiment::ratioColumnsCsv()},
        {QStringLiteral("claims.csv"), experiment::claimsCsv(results, claims)},
        {QStringLiteral("claims-columns.csv"), experiment::claimColumnsCsv()},
        {QStringLiteral("report.html"), experiment::htmlReport(parts)}};
    QStringList drawings;
    for (const experiment::ReportFigure &figure : figures) {
        files.emplace_back(QStringLiteral("figures/%1.svg").arg(QString::fromStdString(figure.name)), figure.svg);
        drawings << folder.filePath(files.back().first);
    }
    if (!folder.mkpath(QStringLiteral("figures")))
        return {false, InputError{sentence("Reason", "the folder cannot be created"), path.toStdString()}.reason()};
    removePictures(folder);
    for (const auto &[name, content] : files) {
        if (Reason problem = write(folder.filePath(name), content); !problem.empty())
            return {false, std::move(problem)};
    }
    return {true, draw(folder, drawings, experiment::printReport(parts), settingOf(results, "time"))};
}

SweepFiles writePooledFiles(const QString &path, const std::vector<experiment::Machine> &machines)
{
    const QDir folder(path);
    if (!folder.mkpath(QStringLiteral("figures")))
        return {false, InputError{sentence("Reason", "the folder cannot be created"), path.toStdString()}.reason()};
    std::vector<std::pair<QString, std::string>> files{{QStringLiteral("report.html"), experiment::pooledHtml(machines)},
                                                       {QStringLiteral("pooled.csv"), experiment::pooledCsv(machines)},
                                                       {QStringLiteral("pooled-columns.csv"), experiment::pooledColumnsCsv()}};
    QStringList drawings;
    for (const experiment::ReportFigure &figure : experiment::forestsOf(machines)) {
        files.emplace_back(QStringLiteral("figures/%1.svg").arg(QString::fromStdString(figure.name)), figure.svg);
        drawings << folder.filePath(files.back().first);
    }
    for (const auto &[name, content] : files) {
        if (Reason problem = write(folder.filePath(name), content); !problem.empty())
            return {false, std::move(problem)};
    }
    std::string newest; // of the sweeps, so that the same sweeps give the same bytes
    for (const experiment::Machine &machine : machines)
        newest = std::max(newest, settingOf(machine.results, "time"));
    return {true, draw(folder, drawings, experiment::pooledPrint(machines), newest)};
}

} // namespace skyseal::app
