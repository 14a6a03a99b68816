#include "app/cli/launched_sweep.h"

#include "core/experiment/idle_power.h"
#include "core/experiment/sweep_reader.h"

#include <QtCore/QJsonDocument>

#include <algorithm>
#include <limits>
#include <utility>
#ifdef Q_OS_LINUX
#include <csignal>
#include <sys/prctl.h>
#include <unistd.h>
#endif

namespace skyseal::app {

namespace {

constexpr int kStopMs = 10000;

/// Options of the whole sweep; true: with a value.
constexpr std::pair<const char *, bool> kOfTheSweep[] = {{"launches", true}, {"seed", true},   {"out", true},
                                                         {"expect", true},   {"margin", true}, {"until", true},
                                                         {"json", false},    {"plan", false},  {"no-noise", false}};

/// The last line of a text.
std::string lastLine(const QByteArray &text)
{
    return text.trimmed().split('\n').last().toStdString();
}

experiment::Plan singleLaunch(experiment::Plan plan)
{
    plan.launches = 1;
    return plan;
}

} // namespace

QStringList launchArguments(const QStringList &arguments, const experiment::Plan &plan, unsigned launch)
{
    QStringList out;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        const QString name = arguments[i].section(QLatin1Char('='), 0, 0);
        const auto found = std::ranges::find_if(
            kOfTheSweep, [&name](const auto &option) { return name == QLatin1String("--") + QLatin1String(option.first); });
        if (found == std::end(kOfTheSweep))
            out << arguments[i];
        else if (found->second && !arguments[i].contains(QLatin1Char('=')))
            ++i; // its value
    }
    const bool noise = std::ranges::any_of(plan.arms, &experiment::SweepArm::again);
    return out << (noise ? QStringLiteral("--noise") : QStringLiteral("--no-noise")) << QStringLiteral("--launches")
               << QStringLiteral("1") << QStringLiteral("--seed") << QString::number(experiment::seedOf(plan, launch))
               << QStringLiteral("--json");
}

LaunchedSweep::LaunchedSweep(experiment::Plan plan, QString program, QStringList arguments,
                             std::function<bool(const experiment::Results &)> enough)
    : m_one(singleLaunch(plan)), m_program(std::move(program)), m_arguments(std::move(arguments)), m_enough(std::move(enough)),
      m_queue(plan)
{
    m_results.plan = std::move(plan);
    connect(&m_process, &QProcess::readyReadStandardOutput, this, &LaunchedSweep::readLines);
    connect(&m_process, &QProcess::finished, this, &LaunchedSweep::endLaunch);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            end(m_program.toStdString() + ": " + m_process.errorString().toStdString());
    });
#ifdef Q_OS_LINUX
    m_process.setChildProcessModifier([parent = ::getpid()] {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (::getppid() != parent)
            ::_exit(1);  // it was killed before the line above
        ::setpgid(0, 0); // Ctrl+C is for this process, which ends the launch in good order
    });
#endif
}

LaunchedSweep::~LaunchedSweep()
{
    m_process.disconnect(this);
    if (m_process.state() == QProcess::NotRunning)
        return;
    m_process.terminate();
    if (!m_process.waitForFinished(kStopMs))
        m_process.kill();
    m_process.waitForFinished(kStopMs);
}

void LaunchedSweep::start()
{
    m_clock.start();
    beginLaunch();
}

void LaunchedSweep::cancel()
{
    m_cancelled = true;
    if (m_process.state() != QProcess::NotRunning)
        m_process.terminate();
}

void LaunchedSweep::beginLaunch()
{
    m_launch.start = static_cast<double>(m_clock.nsecsElapsed()) / 1e9;
    m_launch.order = static_cast<unsigned>(m_results.samples.size());
    m_launch.ended = false;
    m_launch.problem.clear();
    m_process.start(m_program,
                    QStringList{QStringLiteral("sweep")} + launchArguments(m_arguments, m_results.plan, m_launch.number));
}

void LaunchedSweep::readLines()
{
    while (m_process.canReadLine())
        takeLine(m_process.readLine());
}

void LaunchedSweep::takeLine(const QByteArray &line)
{
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    const QString event = object[QLatin1String("event")].toString();
    if (event == QLatin1String("end")) {
        m_launch.ended = true;
        m_launch.problem = object[QLatin1String("problem")].toString().toStdString();
        m_opened = m_opened || object[QLatin1String("opened")].toBool();
        m_results.placement = object[QLatin1String("placement")].toString().toStdString();
        m_results.source = object[QLatin1String("source")].toString().toStdString();
        const double unknown = std::numeric_limits<double>::quiet_NaN();
        experiment::subtractIdle(
            std::span(m_results.samples).subspan(m_launch.order),
            {object[QLatin1String("idle_before")].toDouble(unknown), object[QLatin1String("idle_after")].toDouble(unknown)});
        return;
    }
    if (event == QLatin1String("begin")) {
        if (auto run = experiment::readRun(object, m_one)) {
            run->launch = m_launch.number;
            Q_EMIT runBegan(*run);
        }
        return;
    }
    if (event != QLatin1String("run"))
        return;
    std::optional<experiment::Sample> sample = experiment::readSample(object, m_one);
    if (!sample || m_queue.atEnd())
        return;
    m_opened = true;
    sample->run.launch = m_launch.number;
    sample->order += m_launch.order;
    sample->start += m_launch.start;
    if (m_launch.number > 0) // measured once for each suite, in any launch the same
        sample->values[experiment::Metric::SessionMemory] = std::numeric_limits<double>::quiet_NaN();
    m_queue.finishRun(static_cast<double>(m_clock.nsecsElapsed()) / 1e9);
    m_results.samples.push_back(*sample);
    Q_EMIT sampleTaken(*sample);
}

void LaunchedSweep::endLaunch()
{
    readLines();
    const std::size_t expected = experiment::schedule(m_one).size() * (m_launch.number + 1);
    if (m_cancelled)
        return end("cancelled");
    if (!m_launch.problem.empty())
        return end(m_launch.problem);
    if (!m_launch.ended || m_results.samples.size() != expected)
        return end("launch " + std::to_string(m_launch.number + 1)
                   + " ended early: " + lastLine(m_process.readAllStandardError()));
    ++m_launch.number;
    if (m_launch.number < m_results.plan.launches && !(m_enough && m_enough(m_results)))
        return beginLaunch();
    m_results.plan.launches = m_launch.number;
    end({});
}

void LaunchedSweep::end(const Reason &problem)
{
    m_results.complete = problem.empty();
    m_results.seconds = static_cast<double>(m_clock.nsecsElapsed()) / 1e9;
    Q_EMIT finished(m_opened, problem);
}

} // namespace skyseal::app

#include "moc_launched_sweep.cpp"
