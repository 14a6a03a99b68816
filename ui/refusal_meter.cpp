#include "ui/refusal_meter.h"

namespace skyseal::ui {

std::uint64_t RefusalMeter::handleEvent(const engine::Event &event, double now)
{
    if (std::holds_alternative<channel::SessionUp>(event)) {
        m_refusals.clear();
        m_countsFrom = now + kGrace;
    }
    if (now < m_countsFrom)
        return 0;
    std::uint64_t frames = 0;
    // With `mayBe`, a vehicle only waits for approval.
    if (const auto *clear = std::get_if<engine::PlaintextRefused>(&event); clear && clear->mayBe.empty()) {
        frames = clear->frames;
        m_refusals.push_back({now, clear->systemId, frames});
    } else if (const auto *system = std::get_if<engine::SystemRefused>(&event)) {
        frames = system->frames;
        m_refusals.push_back({now, system->systemId, frames});
    }
    while (!m_refusals.empty() && now - m_refusals.front().time > kWindow)
        m_refusals.pop_front();
    return frames;
}

std::uint64_t RefusalMeter::lastMinute(std::uint8_t systemId, double now) const
{
    std::uint64_t out = 0;
    for (const Refusal &refusal : m_refusals)
        if (refusal.systemId == systemId && now - refusal.time <= kWindow)
            out += refusal.frames;
    return out;
}

} // namespace skyseal::ui
