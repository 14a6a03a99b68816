#include "core/experiment/idle_power.h"

#include "core/link/steady_now.h"

#include <utility>

namespace skyseal::experiment {

namespace {

constexpr int kTickMs = 100;

} // namespace

void subtractIdle(std::span<Sample> samples, const IdlePower &idle)
{
    if (!idle.isKnown())
        return;
    const double watts = (idle.before + idle.after) / 2;
    for (Sample &sample : samples) {
        Values &values = sample.values;
        values[Metric::IdlePower] = watts;
        values[Metric::IdlePowerChange] = 100 * std::abs(idle.after - idle.before) / watts;
        values[Metric::PowerAboveIdle] = values[Metric::Power] - watts;
        values[Metric::EnergyPerFrame] = 1e6 * values[Metric::PowerAboveIdle] * sample.seconds / values[Metric::Packets];
    }
}

IdleMeter::IdleMeter(const std::string &sysfs) : m_energy(sysfs)
{
    m_tick.setInterval(kTickMs);
    connect(&m_tick, &QTimer::timeout, this, [this] {
        const TimePoint now = steadyNow();
        if (now >= m_end)
            finish();
        else
            m_energy.microjoules(now);
    });
}

void IdleMeter::measure(std::function<void(double)> done, int milliseconds)
{
    m_done = std::move(done);
    m_begin = steadyNow();
    m_end = m_begin + std::chrono::milliseconds(milliseconds);
    m_first = m_energy.microjoules(m_begin);
    if (m_first)
        m_tick.start();
    else
        finish();
}

void IdleMeter::finish()
{
    m_tick.stop();
    const auto done = std::exchange(m_done, nullptr);
    if (!done)
        return;
    const TimePoint now = steadyNow();
    const auto last = m_energy.microjoules(now);
    const double passed = seconds(now - m_begin);
    const bool isMeasured = m_first && last && passed > 0;
    done(isMeasured ? static_cast<double>(*last - *m_first) / 1e6 / passed : std::numeric_limits<double>::quiet_NaN());
}

} // namespace skyseal::experiment

#include "moc_idle_power.cpp"
