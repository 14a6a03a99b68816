// The window's sweeps: has one made at a time, on the connected link or on a vehicle of its own, and writes its files.
#pragma once

#include "app/skyseal/sweep_worker.h"
#include "app/skyseal/station_adapter.h"
#include "core/experiment/heap_figures.h"
#include "ui/sweep/sweep_interface.h"

#include <QtCore/QThread>

#include <memory>

namespace skyseal::app {

class SweepController : public ui::SweepInterface
{
    Q_OBJECT

public:
    /// `station` must outlive it. Without `heap` reports do not say what suites take of it.
    SweepController(StationAdapter &station, std::shared_ptr<experiment::HeapFigures> heap);
    /// A sweep that runs still is ended; its link is on its way back to the suite that it had.
    ~SweepController() override;

    QString whyNoOwnVehicle() const override;
    void start(const ui::SweepOrder &order) override;
    void cancel() override;
    void save(const experiment::Results &results, const QString &folder) override;

private:
    void follow();

    StationAdapter &m_station;
    const std::shared_ptr<experiment::HeapFigures> m_heap;
    std::unique_ptr<QThread> m_thread; ///< of a sweep with a vehicle of its own
    SweepWorker *m_bench = nullptr;    ///< lives on that thread, or on ours
    std::unique_ptr<QThread> m_writer;
};

} // namespace skyseal::app
