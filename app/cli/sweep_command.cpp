// skyseal-cli sweep: measures the cost of each suite unattended.
#include "app/cli/commands.h"
#include "app/cli/launched_sweep.h"
#include "app/cli/sweep_options.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/process.h"
#include "app/common/sweep_command_line.h"
#include "app/common/sweep_files.h"
#include "app/common/sweep_setting.h"
#include "core/crypto/system_random.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/idle_power.h"
#include "core/experiment/precision.h"
#include "core/experiment/setting.h"
#include "core/experiment/sweep_json.h"
#include "core/experiment/sweep_runner.h"
#include "core/experiment/sweep_text.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QDir>
#include <QtCore/QTimer>

namespace skyseal::app {

namespace {

const QString kSweepName = QStringLiteral("skyseal-cli sweep");

/// Reports the precision of the sweep and the effort to reach its goal. Returns true if there is no goal, or if it is reached.
bool reportPrecision(const experiment::Results &results, const SweepOptions &options)
{
    constexpr double kUsualGoal = 0.03;
    if (!options.until && !options.forecast)
        return true;
    const double goal = options.until.value_or(kUsualGoal);
    const std::string wanted = experiment::readable(100 * goal) + " %";
    const auto precision = experiment::precisionOf(results, goal);
    if (!precision) {
        complain(kSweepName, "too few valid runs to estimate the precision of the ratios to plain MAVLink");
        return false;
    }
    const unsigned launches = experiment::launchesIn(results);
    const std::string now = "after " + std::to_string(launches) + " launches the ratios by CPU time per frame are known to "
        + experiment::readable(100 * precision->halfWidth) + " %";
    const unsigned needed = std::max(precision->launchesNeeded, experiment::kLeastLaunchesUntil);
    const std::string more = wanted + " takes about " + std::to_string(needed) + " launches, "
        + experiment::readable(needed * results.seconds / launches / 60) + " minutes";
    if (options.forecast) {
        remark(now + "; " + more);
        return true;
    }
    const bool reached = precision->halfWidth <= goal;
    if (reached)
        remark(now);
    else
        complain(kSweepName,
                 now + ", and " + wanted + " is out of reach within " + std::to_string(results.plan.launches)
                     + " launches: " + more);
    return reached;
}

/// Writes and reports a finished sweep; returns the exit status.
int finishSweep(const experiment::Results &results, const SweepOptions &options)
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
        printLine(options.json ? experiment::expectEvent(results.plan, verdict)
                               : experiment::verdictText(verdict, results.plan));
        hold = hold && verdict.outcome.holds;
    }
    if (!options.folder.isEmpty()) {
        const SweepFiles files = writeSweepFiles(options.folder, results, verdicts);
        if (!files.problem.empty())
            complain(kSweepName, files.problem.text());
        if (!files.written)
            return kCannotOpen;
        if (!options.json)
            remark("written to " + options.folder.toStdString());
    }
    const Reason failed = experiment::failedRuns(results), ended = experiment::endedEarly(results);
    const Reason invalid = experiment::invalidRuns(results), disturbed = experiment::disturbedRuns(results);
    if (!disturbed.empty())
        remark(disturbed.text());
    for (const Reason &problem : {failed, invalid}) {
        if (!problem.empty())
            complain(kSweepName, problem.text());
    }
    if (!ended.empty())
        complain(kSweepName, ended.text());
    const bool isPrecise = reportPrecision(results, options);
    return hold && isPrecise && failed.empty() && invalid.empty() && ended.empty() ? kDone : kNotReached;
}

/// `Sweep`: a SweepRunner, or a LaunchedSweep. `idleMeter`: null without programs of this process's own. Returns the exit
/// status.
template<typename Sweep>
int carryOut(Sweep &sweep, const SweepOptions &options, const experiment::Setting &setting, experiment::HeapFigures &heap,
             experiment::IdleMeter *idleMeter)
{
    StopSignals signals;
    bool isStopped = false;
    QObject::connect(&signals, &StopSignals::stopRequested, qApp, [&] {
        isStopped = true;
        if (idleMeter)
            idleMeter->finish();
    });
    QObject::connect(&signals, &StopSignals::stopRequested, &sweep, &Sweep::cancel);
    if (options.flight.exists())
        QObject::connect(&signals, &StopSignals::stopRequested, qApp, [] {
            remark("the vehicle is brought down first; a second signal ends the sweep at once and leaves the vehicle in the "
                   "air");
        });
    if (options.json)
        QObject::connect(&sweep, &Sweep::runBegan, qApp, [&](const experiment::Run &run) {
            printLine(experiment::beginEvent(options.plan, run, sweep.results().samples.size()));
        });
    QObject::connect(&sweep, &Sweep::sampleTaken, qApp, [&](const experiment::Sample &sample) {
        if (options.json)
            printLine(experiment::runEvent(options.plan, sample, sweep.runs(), sweep.remaining()));
        remark(experiment::runText(options.plan, sample, sweep.runs(), sweep.remaining()));
    });
    int status = kDone;
    experiment::IdlePower idle;
    const auto end = [&](bool opened, const Reason &problem) {
        experiment::Results results = sweep.results();
        results.setting = setting;
        results.contextBytes = contextSizes(heap);
        experiment::subtractIdle(results.samples, idle);
        const bool nothing = results.samples.empty();
        status = !opened ? kCannotOpen : nothing ? kNotReached : finishSweep(results, options);
        if (options.json)
            printLine(experiment::endEvent(results, opened, problem.text(), idle));
        QCoreApplication::exit(status);
    };
    QObject::connect(
        &sweep, &Sweep::finished, qApp,
        [&](bool opened, const Reason &problem) {
            if (!problem.empty())
                complain(kSweepName, problem.text());
            if (!idleMeter || isStopped || !opened)
                return end(opened, problem);
            idleMeter->measure([&, opened, problem](double watts) {
                idle.after = watts;
                end(opened, problem);
            });
        },
        Qt::QueuedConnection);
    QTimer::singleShot(0, &sweep, [&] {
        if (!idleMeter)
            return sweep.start();
        idleMeter->measure([&](double watts) {
            idle.before = watts;
            sweep.start();
        });
    });
    QCoreApplication::exec();
    return status;
}

} // namespace

int runSweep(const QStringList &arguments)
{
    SweepOptions options;
    if (const auto status = readSweepOptions(kSweepName, arguments, options))
        return *status;
    if (!options.folder.isEmpty() && !QDir().mkpath(options.folder)) {
        complain(kSweepName, options.folder.toStdString() + ": the folder cannot be created");
        return kCannotOpen;
    }
    experiment::HeapFigures heap; // before threads start
    crypto::SystemRandom random;
    std::unique_ptr<experiment::Lab> lab;
    engine::StationConfig station = options.station;
    std::optional<link::LinkUrl> link = options.link;
    std::string bareKey;
    if (!link && options.plan.launches == 1) { // otherwise each launch makes its own
        auto made = experiment::Lab::create({programPath(QStringLiteral("skyseal-sim")),
                                             programPath(QStringLiteral("skyseal-air")),
                                             QCoreApplication::applicationFilePath()},
                                            random, options.vehicle);
        if (!made) {
            complain(kSweepName, made.error().text());
            return kCannotOpen;
        }
        lab = std::move(*made);
        station.keys = lab->stationKeys();
        bareKey = lab->bareKey();
        link = *link::LinkUrl::parse("udpin:127.0.0.1:" + std::to_string(lab->groundPort()));
    }

    experiment::Setting setting = describeSetting(SKYSEAL_CLI_VERSION,
                                                  kSweepName + QLatin1Char(' ') + shellText(options.repeatedBy));
    setting.emplace_back("message_mix", messageMix(options.link, options.vehicle, options.flight.script));
    for (const Reason &warning : experiment::warningsOf(setting))
        remark(warning.text());
    if (options.plan.launches > 1) {
        std::function<bool(const experiment::Results &)> enough;
        if (options.until && !options.forecast)
            enough = [goal = *options.until](const experiment::Results &results) {
                const auto precision = experiment::precisionOf(results, goal);
                return experiment::launchesIn(results) >= experiment::kLeastLaunchesUntil && precision
                    && precision->halfWidth <= goal;
            };
        LaunchedSweep sweep(options.plan, QCoreApplication::applicationFilePath(), arguments, std::move(enough));
        return carryOut(sweep, options, setting, heap, nullptr); // each launch has its own
    }
    experiment::SweepRunner sweep({options.plan, *link, station, lab.get(), bareKey, &heap, options.flight});
    experiment::IdleMeter idleMeter;
    return carryOut(sweep, options, setting, heap, lab ? &idleMeter : nullptr);
}

} // namespace skyseal::app
