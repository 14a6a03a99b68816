#include "app/cli/transfer/vehicle_task.h"

#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/engine/station/snapshot.h"

#include <algorithm>
#include <variant>

namespace skyseal::app {

namespace {

constexpr Duration kShowEvery = std::chrono::seconds(1);

} // namespace

void VehicleTask::advance(TimePoint now, const engine::Snapshot &snapshot)
{
    if (m_finished)
        return;
    if (m_systemId == 0)
        find(now, snapshot);
    else
        showProgress(now, snapshot);
}

void VehicleTask::find(TimePoint now, const engine::Snapshot &snapshot)
{
    if (!m_begun)
        m_begun = now;
    const auto &vehicles = snapshot.vehicles;
    const auto wanted = std::ranges::find_if(vehicles, [this](const engine::VehicleSnapshot &vehicle) {
        return m_settings.systemId == 0 || vehicle.state.systemId == m_settings.systemId;
    });
    if (wanted != vehicles.end() && !m_firstFound)
        m_firstFound = now;
    if (wanted != vehicles.end() && (m_settings.systemId != 0 || now >= *m_firstFound + kOthers)) {
        if (m_settings.systemId == 0 && vehicles.size() > 1) {
            std::string ids;
            for (const engine::VehicleSnapshot &vehicle : vehicles)
                ids += (ids.empty() ? "" : ", ") + std::to_string(vehicle.state.systemId);
            return finish("there are several vehicles: " + ids + "; choose one with --sysid");
        }
        m_systemId = wanted->state.systemId;
        return start(wanted->state);
    }
    if (now >= *m_begun + m_settings.findWithin)
        finish(m_settings.systemId == 0 ? "no vehicle was heard"
                                        : "vehicle " + std::to_string(m_settings.systemId) + " was not heard");
}

void VehicleTask::showProgress(TimePoint now, const engine::Snapshot &snapshot)
{
    if (now < m_shown + kShowEvery)
        return;
    for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles) {
        for (const vehicle::TransferProgress &progress : vehicle.state.transfers) {
            if (vehicle.state.systemId != m_systemId || progress.id != m_current || progress.done == m_shownDone)
                continue;
            m_shown = now;
            m_shownDone = progress.done;
            if (m_settings.json) {
                JsonWriter json;
                json.beginObject().field("event", "progress").field("sysid", unsigned(m_systemId));
                json.field("done", progress.done).field("total", progress.total).endObject();
                printLine(json.text());
            } else {
                remark(std::to_string(progress.done)
                       + (progress.total > 0 ? " of " + std::to_string(progress.total) : std::string()));
            }
        }
    }
}

void VehicleTask::handle(const engine::Event &event)
{
    std::visit(
        [this](const auto &result) {
            if constexpr (requires { dispatch(result); }) {
                if (!m_finished && m_systemId != 0 && result.systemId == m_systemId && result.id == m_current)
                    dispatch(result);
            }
        },
        event);
}

void VehicleTask::finish(std::string problem)
{
    m_finished = true;
    m_problem = std::move(problem);
}

void VehicleTask::finishSaved(std::string problem)
{
    m_isFileProblem = !problem.empty();
    finish(std::move(problem));
}

} // namespace skyseal::app
