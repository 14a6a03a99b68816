#include "app/skyseal/sweep_worker.h"

#include "app/common/sweep_command_line.h"
#include "app/common/sweep_files.h"
#include "app/common/sweep_setting.h"
#include "core/channel/policy.h"
#include "core/crypto/system_random.h"
#include "core/engine/text/qt_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::app {

namespace {

/// The command line that repeats a sweep with its own agent; for a connected link, a description.
QString commandOf(const ui::SweepOrder &order)
{
    QStringList words{QStringLiteral("skyseal-cli"), QStringLiteral("sweep")};
    if (order.target == ui::SweepTarget::Connected)
        return QStringLiteral("skyseal, on the connected link; as ") + shellText(words) + QStringLiteral(" --link URL ")
            + shellText(sweepArguments(order.plan));
    if (order.autopilot)
        words << QStringLiteral("--vehicle") << QString::fromStdString(order.autopilot->toText());
    return shellText(words << sweepArguments(order.plan));
}

} // namespace

SweepWorker::SweepWorker(ui::SweepOrder order, engine::Station *station, experiment::HeapFigures *heap)
    : m_order(std::move(order)), m_station(station), m_heap(heap)
{}

SweepWorker::~SweepWorker()
{
    m_runner.reset(); // before the programs it measures
}

ui::SweepProgress SweepWorker::progress() const
{
    return {m_runner->results().samples.size(), m_runner->runs(), m_runner->remaining()};
}

void SweepWorker::begin()
{
    m_setting = describeSetting(QCoreApplication::applicationVersion().toUtf8().constData(), commandOf(m_order));
    if (!m_station)
        m_setting.emplace_back("message_mix", messageMix(std::nullopt, m_order.autopilot, {}));
    m_setting.emplace_back("measured_in",
                           m_station ? "the window's process and by its station; drawing is in cpu_process and memory, not in "
                                       "cpu; snapshots for the window are in cpu, and meter_cpu states their share"
                                     : "the window's process; its drawing is in cpu_process and memory, not in cpu");
    experiment::SweepConfig config;
    config.plan = m_order.plan;
    config.borrowed = m_station;
    config.heap = m_heap;
    if (!m_station) {
        crypto::SystemRandom random;
        auto lab = experiment::Lab::create({programPath(QStringLiteral("skyseal-sim")),
                                            programPath(QStringLiteral("skyseal-air")),
                                            programPath(QStringLiteral("skyseal-cli"))},
                                           random, m_order.autopilot);
        if (!lab)
            return end(engine::reasonText(lab.error().reason()));
        m_lab = std::move(*lab);
        config.lab = m_lab.get();
        config.link = *link::LinkUrl::parse("udpin:127.0.0.1:" + std::to_string(m_lab->groundPort()));
        config.station.keys = m_lab->stationKeys();
        config.bareKey = m_lab->bareKey();
        config.station.policy.suites = channel::defaultSuites();
        config.station.policy.allowResearch = config.station.policy.allowPlain = true;
    }
    m_runner = std::make_unique<experiment::SweepRunner>(std::move(config));
    connect(m_runner.get(), &experiment::SweepRunner::runBegan, this,
            [this](const experiment::Run &run) { Q_EMIT runBegan(run, progress()); });
    connect(m_runner.get(), &experiment::SweepRunner::sampleTaken, this,
            [this](const experiment::Sample &sample) { Q_EMIT sampleTaken(sample, progress()); });
    // Queued, since the runner is deleted.
    connect(
        m_runner.get(), &experiment::SweepRunner::finished, this,
        [this](bool, const Reason &problem) { end(engine::reasonText(problem)); }, Qt::QueuedConnection);
    if (m_cancelled)
        return end(engine::reasonText(sentence("Reason", "cancelled")));
    m_runner->start();
}

void SweepWorker::cancel()
{
    m_cancelled = true;
    if (m_runner)
        m_runner->cancel();
}

void SweepWorker::end(const QString &problem)
{
    auto results = std::make_shared<experiment::Results>();
    results->plan = m_order.plan;
    if (m_runner)
        *results = m_runner->results();
    results->setting = std::move(m_setting);
    if (m_heap)
        results->contextBytes = contextSizes(*m_heap);
    m_runner.reset();
    m_lab.reset();
    Q_EMIT finished(std::move(results), problem);
}

} // namespace skyseal::app

#include "moc_sweep_worker.cpp"
