// A sweep of several launches: each is a sweep of one launch in a process of its own, so that the station starts anew as well
// as the programs that it measures. Adds the launches up.
#pragma once

#include "core/experiment/results.h"
#include "core/experiment/run_queue.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QObject>
#include <QtCore/QProcess>
#include <QtCore/QStringList>

#include <functional>
#include <string>

namespace skyseal::app {

/// The arguments of one launch of the sweep that has these: without what concerns the whole sweep (files, assertions, number of
/// launches, seed), and with the launch's own seed.
QStringList launchArguments(const QStringList &arguments, const experiment::Plan &plan, unsigned launch);

class LaunchedSweep : public QObject
{
    Q_OBJECT

public:
    /// `program`: skyseal-cli. `enough`: asked after each launch; true ends the sweep as complete.
    LaunchedSweep(experiment::Plan plan, QString program, QStringList arguments,
                  std::function<bool(const experiment::Results &)> enough = {});
    ~LaunchedSweep() override;

    void start();
    /// Ends the launch that runs; the samples so far are kept.
    void cancel();

    const experiment::Results &results() const { return m_results; }
    std::size_t runs() const { return m_queue.size(); }
    double remaining() const { return m_queue.remaining(); }

Q_SIGNALS:
    /// As SweepRunner::runBegan().
    void runBegan(const skyseal::experiment::Run &run);
    void sampleTaken(const skyseal::experiment::Sample &sample);
    /// As SweepRunner::finished().
    void finished(bool opened, const skyseal::Reason &problem);

private:
    void beginLaunch();
    void readLines();
    void takeLine(const QByteArray &line);
    void endLaunch();
    void end(const Reason &problem);

    struct Launch
    {
        unsigned number = 0;
        double start = 0;    ///< seconds since the sweep began
        unsigned order = 0;  ///< of its first run
        bool ended = false;  ///< its last line was read
        std::string problem; ///< that it ended with
    };

    experiment::Plan m_one; ///< of a single launch
    QString m_program;
    QStringList m_arguments;
    std::function<bool(const experiment::Results &)> m_enough;
    experiment::Results m_results;
    experiment::RunQueue m_queue;
    QProcess m_process;
    QElapsedTimer m_clock;
    Launch m_launch;
    bool m_opened = false, m_cancelled = false;
};

} // namespace skyseal::app
