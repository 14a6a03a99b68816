// skyseal-cli sweep: measures the cost of each suite unattended.
#include "app/cli/commands.h"
#include "app/cli/sweep_options.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/process.h"
#include "app/common/sweep_files.h"
#include "app/common/sweep_setting.h"
#include "core/crypto/system_random.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/setting.h"
#include "core/experiment/sweep_json.h"
#include "core/experiment/sweep_runner.h"
#include "core/experiment/sweep_text.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>

namespace skyseal::app {

namespace {

const QString kName = QStringLiteral("skyseal-cli sweep");

/// Writes and reports a finished sweep; returns the exit status.
int conclude(const experiment::Results &results, const SweepOptions &options, experiment::HeapFigures &heap)
{
    std::vector<experiment::Verdict> verdicts;
    for (const experiment::Expectation &expectation : options.expectations) {
        const auto judged = experiment::judge(expectation, results);
        verdicts.insert(verdicts.end(), judged.begin(), judged.end());
    }
    if (!options.json) {
        for (const std::string &line : experiment::sweepText(results))
            printLine(line);
    }
    bool hold = true;
    for (const experiment::Verdict &verdict : verdicts) {
        printLine(options.json ? experiment::expectEvent(results.plan, verdict) : experiment::sentence(verdict, results.plan));
        hold = hold && verdict.outcome.holds;
    }
    if (!options.folder.isEmpty()) {
        const SweepFiles files = writeSweepFiles(options.folder, results, verdicts, contextSizes(heap));
        if (!files.problem.empty())
            complain(kName, files.problem);
        if (!files.written)
            return kCannotOpen;
        if (!options.json)
            remark("written to " + options.folder.toStdString());
    }
    const std::string failed = experiment::failedRuns(results), ended = experiment::endedEarly(results);
    const std::string invalid = experiment::invalidRuns(results), disturbed = experiment::disturbedRuns(results);
    if (!disturbed.empty())
        remark(disturbed);
    for (const std::string &problem : {failed, invalid}) {
        if (!problem.empty())
            complain(kName, problem);
    }
    if (!ended.empty())
        complain(kName, ended);
    return hold && failed.empty() && invalid.empty() && ended.empty() ? kDone : kNotReached;
}

} // namespace

int runSweep(const QStringList &arguments)
{
    SweepOptions options;
    if (const auto status = readSweepOptions(kName, arguments, options))
        return *status;
    if (!options.folder.isEmpty() && !QDir().mkpath(options.folder)) {
        complain(kName, options.folder.toStdString() + ": the folder cannot be created");
        return kCannotOpen;
    }
    experiment::HeapFigures heap; // before threads start
    crypto::SystemRandom random;
    std::unique_ptr<experiment::Lab> lab;
    engine::StationConfig station = options.station;
    std::optional<link::LinkUrl> link = options.link;
    if (!link) {
        auto made = experiment::Lab::create({programPath(QStringLiteral("skyseal-sim")),
                                             programPath(QStringLiteral("skyseal-air")),
                                             QCoreApplication::applicationFilePath()},
                                            random);
        if (!made) {
            complain(kName, made.error().text());
            return kCannotOpen;
        }
        lab = std::move(*made);
        station.keys = lab->stationKeys();
        link = *link::LinkUrl::parse("udpin:127.0.0.1:" + std::to_string(lab->groundPort()));
    }

    QString command = kName + QLatin1Char(' ') + arguments.join(QLatin1Char(' '));
    if (!options.seedGiven)
        command += QStringLiteral(" --seed %1").arg(options.plan.seed); // the command line that repeats this sweep
    const experiment::Setting setting = describeSetting(SKYSEAL_CLI_VERSION, command);
    for (const std::string &warning : experiment::warningsOf(setting))
        remark(warning);
    experiment::SweepRunner runner({options.plan, *link, station, lab.get(), &heap});
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &runner, &experiment::SweepRunner::cancel);
    QObject::connect(&runner, &experiment::SweepRunner::sampleTaken, qApp, [&](const experiment::Sample &sample) {
        if (options.json)
            printLine(experiment::runEvent(options.plan, sample, runner.runs(), runner.remaining()));
        remark(experiment::runText(options.plan, sample, runner.runs(), runner.remaining()));
    });
    int status = kDone;
    QObject::connect(
        &runner, &experiment::SweepRunner::finished, qApp,
        [&](bool opened, const std::string &problem) {
            if (!problem.empty())
                complain(kName, problem);
            experiment::Results results = runner.results();
            results.setting = setting;
            const bool nothing = results.samples.empty();
            status = !opened ? kCannotOpen : nothing ? kNotReached : conclude(results, options, heap);
            QCoreApplication::exit(status);
        },
        Qt::QueuedConnection);
    QMetaObject::invokeMethod(&runner, &experiment::SweepRunner::start, Qt::QueuedConnection);
    QCoreApplication::exec();
    return status;
}

} // namespace skyseal::app
