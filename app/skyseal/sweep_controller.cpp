#include "app/skyseal/sweep_controller.h"

#include "app/common/sweep_files.h"
#include "app/skyseal/demo.h"
#include "core/engine/text/qt_text.h"

namespace skyseal::app {

SweepController::SweepController(StationAdapter &station, std::shared_ptr<experiment::HeapFigures> heap)
    : m_station(station), m_heap(std::move(heap))
{}

SweepController::~SweepController()
{
    if (m_thread) {
        m_thread->quit(); // which deletes the worker
        m_thread->wait();
    } else {
        delete m_worker;
    }
    if (m_writer)
        m_writer->wait();
}

QString SweepController::ownProgramsDisabledReason() const
{
    const bool all = Demo::isAvailable() && !programPath(QStringLiteral("skyseal-cli")).isEmpty();
    return all ? QString() : tr("skyseal-sim, skyseal-air or skyseal-cli is not installed");
}

void SweepController::start(const ui::SweepOrder &order)
{
    if (m_worker)
        return;
    const bool ownAgent = ui::hasOwnAgent(order.target);
    if (!ownAgent && !m_station.isRunning()) {
        auto nothing = std::make_shared<experiment::Results>();
        nothing->plan = order.plan;
        Q_EMIT finished(std::move(nothing), tr("the station is not running"));
        return;
    }
    m_worker = new SweepWorker(order, ownAgent ? nullptr : &m_station.station(), m_heap.get());
    follow();
    if (ownAgent) {
        m_thread = std::make_unique<QThread>();
        m_thread->setObjectName(QStringLiteral("skyseal-sweep"));
        m_worker->moveToThread(m_thread.get());
        connect(m_thread.get(), &QThread::finished, m_worker, &QObject::deleteLater);
        m_thread->start();
    }
    QMetaObject::invokeMethod(m_worker, &SweepWorker::begin, Qt::QueuedConnection);
}

void SweepController::follow()
{
    connect(m_worker, &SweepWorker::runBegan, this, &SweepController::runBegan);
    connect(m_worker, &SweepWorker::sampleTaken, this, &SweepController::sampleTaken);
    connect(
        m_worker, &SweepWorker::finished, this,
        [this](const std::shared_ptr<const experiment::Results> &results, const QString &problem) {
            if (m_thread) {
                m_thread->quit(); // the worker is done
                m_thread->wait();
                m_thread.reset();
            } else {
                m_worker->deleteLater();
            }
            m_worker = nullptr;
            Q_EMIT finished(results, problem);
        },
        Qt::QueuedConnection);
}

void SweepController::cancel()
{
    if (m_worker)
        QMetaObject::invokeMethod(m_worker, &SweepWorker::cancel, Qt::QueuedConnection);
}

void SweepController::save(const experiment::Results &results, const QString &folder)
{
    if (m_writer)
        return;
    // On a thread, since drawing the pictures takes seconds.
    m_writer.reset(QThread::create([this, results, folder] {
        const SweepFiles files = writeSweepFiles(folder, results, {});
        QMetaObject::invokeMethod(this, [this, folder, files] {
            m_writer->wait();
            m_writer.reset();
            Q_EMIT saved(folder, files.written, engine::reasonText(files.problem));
        });
    }));
    m_writer->start();
}

} // namespace skyseal::app

#include "moc_sweep_controller.cpp"
