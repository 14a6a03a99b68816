#include "core/engine/common/channel_costs.h"

#include "core/metrics/process_usage.h"

namespace skyseal::engine {

void ChannelCosts::opened(std::uint64_t begin, std::uint64_t end, const channel::Delivery &delivery)
{
    const std::uint64_t taken = m_clock.between(begin, end);
    m_meters[delivery.session].opened(delivery.suite, taken, delivery.frames.size(), m_slept);
    if (m_measuring)
        m_opening.record(taken);
}

void ChannelCosts::sealed(std::uint64_t begin, std::uint64_t end, channel::SessionId session, crypto::SuiteId suite)
{
    const std::uint64_t taken = m_clock.between(begin, end);
    m_meters[session].sealed(suite, taken);
    if (m_measuring)
        m_sealing.record(taken);
}

void ChannelCosts::roll(TimePoint now)
{
    for (auto &[session, meter] : m_meters)
        meter.roll(now);
}

SuiteCost ChannelCosts::of(channel::SessionId session) const
{
    const auto found = m_meters.find(session);
    return found == m_meters.end() ? SuiteCost{} : found->second.cost();
}

channel::EndCosts ChannelCosts::endCosts(channel::SessionId session) const
{
    const auto found = m_meters.find(session);
    channel::EndCosts out = found == m_meters.end() ? channel::EndCosts{} : found->second.sums();
    using Microseconds = std::chrono::duration<std::uint64_t, std::micro>;
    out.cpuMicroseconds = std::chrono::duration_cast<Microseconds>(metrics::processCpuTime()).count();
    out.residentBytes = metrics::residentBytes().value_or(0);
    return out;
}

} // namespace skyseal::engine
