// The power of the machine while nothing of a sweep runs, before and after each launch: what the runs are charged with is above
// it. Lives on the thread of its owner.
#pragma once

#include "core/experiment/results.h"
#include "core/metrics/energy_meter.h"

#include <QtCore/QObject>
#include <QtCore/QTimer>

#include <functional>
#include <span>

namespace skyseal::experiment {

/// Fills Metric::IdlePower, IdlePowerChange, PowerAboveIdle and EnergyPerFrame of the samples of one launch.
void subtractIdle(std::span<Sample> samples, const IdlePower &idle);

/// Measures for some seconds, then calls `done` with the watts; at once, with NaN, where no energy can be read.
class IdleMeter : public QObject
{
    Q_OBJECT

public:
    static constexpr int kMilliseconds = 5000;

    /// `sysfs`: see metrics::EnergyMeter.
    explicit IdleMeter(const std::string &sysfs = metrics::EnergyMeter::kSysfs);

    void measure(std::function<void(double watts)> done, int milliseconds = kMilliseconds);
    /// Ends a measurement early.
    void finish();

private:
    metrics::EnergyMeter m_energy;
    std::function<void(double)> m_done;
    std::optional<std::uint64_t> m_first;
    TimePoint m_begin{}, m_end{};
    QTimer m_tick{this}; ///< a power sensor has to be read often
};

} // namespace skyseal::experiment
