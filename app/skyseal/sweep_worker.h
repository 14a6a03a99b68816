// One sweep of the window: the runner, and where it has a vehicle of its own the programs for it. Lives on the thread that
// it is moved to before begin(): the window's for the connected link, whose station lives there, and one of its own
// otherwise, since starting and ending programs waits for them.
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
    /// Without a station a simulator and an agent are started for it. `heap` may be null and must outlive it, as the station.
    SweepWorker(experiment::Plan plan, engine::Station *station, experiment::HeapFigures *heap);
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

    experiment::Plan m_plan;
    engine::Station *m_station;
    experiment::HeapFigures *m_heap;
    std::unique_ptr<experiment::Lab> m_lab;
    std::unique_ptr<experiment::SweepRunner> m_runner;
    experiment::Setting m_setting;
    bool m_cancelled = false;
};

} // namespace skyseal::app
