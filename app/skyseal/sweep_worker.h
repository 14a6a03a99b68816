// One sweep of the window: the runner and, for a sweep with its own vehicle, the programs of the vehicle. Lives on the thread
// that it is moved to before begin(): the window's thread for the connected link, whose station lives there, otherwise a
// thread of its own, since starting and ending programs blocks.
#pragma once

#include "core/experiment/lab.h"
#include "core/experiment/sweep_runner.h"
#include "ui/sweep/sweep_interface.h"

#include <QtCore/QObject>

#include <memory>

namespace skyseal::app {

class SweepWorker : public QObject
{
    Q_OBJECT

public:
    /// Without a station it starts an agent and, where the order names no autopilot, a simulator. `heap` (may be null) and the
    /// station must outlive it.
    SweepWorker(ui::SweepOrder order, engine::Station *station, experiment::HeapFigures *heap);
    ~SweepWorker() override;

    void begin();
    void cancel();

Q_SIGNALS:
    void runBegan(const skyseal::experiment::Run &run, const skyseal::ui::SweepProgress &progress);
    void sampleTaken(const skyseal::experiment::Sample &sample, const skyseal::ui::SweepProgress &progress);
    void finished(std::shared_ptr<const skyseal::experiment::Results> results, const QString &problem);

private:
    void end(const QString &problem);
    ui::SweepProgress progress() const;

    ui::SweepOrder m_order;
    engine::Station *m_station;
    experiment::HeapFigures *m_heap;
    std::unique_ptr<experiment::Lab> m_lab;
    std::unique_ptr<experiment::SweepRunner> m_runner;
    experiment::Setting m_setting;
    bool m_cancelled = false;
};

} // namespace skyseal::app
