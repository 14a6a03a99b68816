// The window's sweeps, one at a time, on the connected link or on its own simulated vehicle. Writes their files.
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
    /// `station` must outlive it. Without `heap` reports do not contain the memory of suites.
    SweepController(StationAdapter &station, std::shared_ptr<experiment::HeapFigures> heap);
    /// Ends a running sweep; its link is switched back to the previous suite.
    ~SweepController() override;

    QString ownProgramsDisabledReason() const override;
    void start(const ui::SweepOrder &order) override;
    void cancel() override;
    void save(const experiment::Results &results, const QString &folder) override;

private:
    void follow();

    StationAdapter &m_station;
    const std::shared_ptr<experiment::HeapFigures> m_heap;
    std::unique_ptr<QThread> m_thread; ///< for a sweep with its own vehicle
    SweepWorker *m_worker = nullptr;   ///< lives on that thread, or on the GUI thread
    std::unique_ptr<QThread> m_writer;
};

} // namespace skyseal::app
