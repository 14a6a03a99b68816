#include "ui/refusal_meter.h"

#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "ui/view_state.h"

namespace skyseal::ui {

std::uint64_t RefusalMeter::handleEvent(const engine::Event &event, double now)
{
    if (std::holds_alternative<channel::SessionUp>(event)) {
        m_refusals.clear();
        m_totals.clear();
        m_countsFrom = now + kGrace;
    }
    if (now < m_countsFrom)
        return 0;
    std::uint64_t frames = 0;
    const auto count = [&](std::uint8_t systemId) {
        m_refusals.push_back({now, systemId, frames});
        m_totals[systemId] += frames;
    };
    // With `mayBe`, a vehicle only waits for approval.
    if (const auto *clear = std::get_if<engine::PlaintextRefused>(&event); clear && clear->mayBe.empty()) {
        frames = clear->frames;
        count(clear->systemId);
    } else if (const auto *system = std::get_if<engine::SystemRefused>(&event)) {
        frames = system->frames;
        count(system->systemId);
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

std::uint64_t RefusalMeter::total(std::uint8_t systemId) const
{
    const auto found = m_totals.find(systemId);
    return found == m_totals.end() ? 0 : found->second;
}

void RefusalMeter::mark(ViewState &view, double now) const
{
    const bool counts = view.vehicle && !view.isReplay();
    view.refusedLastMinute = counts ? lastMinute(view.vehicle->state.systemId, now) : 0;
    view.refused = counts ? total(view.vehicle->state.systemId) : 0;
}

RefusedFrames refusedFrames(const engine::SessionSnapshot &session, bool outside)
{
    RefusedFrames out;
    if (session.forgedLastMinute > 0 || outside)
        out.forged = session.stats.rx.forged;
    if (session.replayedLastMinute > session.goodLastMinute)
        out.replayed = session.stats.rx.replayed;
    return out;
}

} // namespace skyseal::ui
