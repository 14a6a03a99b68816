// The window's sweeps: has one made at a time, on the connected link or on a vehicle of its own, and writes its files.
#pragma once

#include "app/skyseal/sweep_bench.h"
#include "app/skyseal/station_adapter.h"
#include "ui/sweep/sweep_port.h"

#include <QtCore/QThread>

#include <memory>

namespace skyseal::app {

class SweepDesk : public ui::SweepPort
{
    Q_OBJECT

public:
    /// `station` must outlive it.
    explicit SweepDesk(StationAdapter &station);
    /// A sweep that runs still is ended; its link is on its way back to the suite that it had.
    ~SweepDesk() override;

    QString whyNoOwnVehicle() const override;
    void start(const ui::SweepOrder &order) override;
    void cancel() override;
    void save(const experiment::Results &results, const QString &folder) override;

private:
    void follow();

    StationAdapter &m_station;
    std::unique_ptr<QThread> m_thread; ///< of a sweep with a vehicle of its own
    SweepBench *m_bench = nullptr;     ///< lives on that thread, or on ours
    std::unique_ptr<QThread> m_writer;
};

} // namespace skyseal::app
