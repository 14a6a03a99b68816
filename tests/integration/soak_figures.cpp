#include "tests/integration/soak_figures.h"

#include "tests/support/process_figures.h"

#include <algorithm>

namespace skyseal::test {

namespace {

constexpr double kWarm = 15;              // s; sessions, clients and streams are there
constexpr qint64 kMostGrowth = 4096;      // kB
constexpr qsizetype kMostDescriptors = 8; // connections of clients and of the broker come and go

double quantile(std::vector<double> values, double part)
{
    std::ranges::sort(values);
    return values.empty() ? 0 : values[std::min(values.size() - 1, std::size_t(part * double(values.size())))];
}

} // namespace

void SoakFigures::noteRecovery(const QByteArray &disturbance, double firstFrame, double all)
{
    for (const QByteArray &name : {disturbance, QByteArray("all of them")}) {
        m_recoveries[name].firstFrame.push_back(firstFrame);
        m_recoveries[name].all.push_back(all);
    }
}

void SoakFigures::noteProcesses(const SoakChain &chain, double now)
{
    for (const Part part : kParts) {
        const qint64 pid = chain.pid(part);
        Life &life = m_lives[part];
        Growth &growth = m_growth[part];
        if (pid != life.pid) {
            life = {pid, now, 0, 0};
            ++growth.lives;
        }
        growth.peak = std::max(growth.peak, statusKilobytes(pid, "VmHWM"));
        growth.longest = std::max(growth.longest, now - life.since);
        if (now - life.since < kWarm)
            continue;
        const qint64 memory = statusKilobytes(pid, "VmRSS");
        const qsizetype open = descriptors(pid);
        if (life.warmMemory == 0) {
            life.warmMemory = memory;
            life.warmDescriptors = open;
        }
        growth.memory = std::max(growth.memory, memory - life.warmMemory);
        growth.descriptors = std::max(growth.descriptors, open - life.warmDescriptors);
    }
}

QString SoakFigures::growth() const
{
    QStringList out;
    for (const auto &[part, growth] : m_growth) {
        if (growth.memory > kMostGrowth)
            out << QStringLiteral("%1: memory by %2 kB").arg(QLatin1String(nameOf(part))).arg(growth.memory);
        if (growth.descriptors > kMostDescriptors)
            out << QStringLiteral("%1: descriptors by %2").arg(QLatin1String(nameOf(part))).arg(growth.descriptors);
    }
    return out.join(QStringLiteral(", "));
}

void SoakFigures::print() const
{
    qInfo("%-34s %5s   first frame, s: median   p99   max   all parts, s: median   p99   max", "disturbance", "times");
    for (const auto &[name, recovery] : m_recoveries)
        qInfo("%-34s %5zu %23.2f %5.2f %5.2f %22.2f %5.2f %5.2f", name.constData(), recovery.all.size(),
              quantile(recovery.firstFrame, 0.5), quantile(recovery.firstFrame, 0.99), quantile(recovery.firstFrame, 1),
              quantile(recovery.all, 0.5), quantile(recovery.all, 0.99), quantile(recovery.all, 1));
    qInfo("%-20s lives  longest, s  most growth once warm: kB  descriptors  peak, kB", "program");
    for (const auto &[part, growth] : m_growth)
        qInfo("%-20s %5d %11.0f %26lld %12lld %9lld", nameOf(part), growth.lives, growth.longest, growth.memory,
              qint64(growth.descriptors), growth.peak);
}

} // namespace skyseal::test
