// Base of the commands that ask one vehicle for something: it finds the vehicle, sends one request after the other, shows the
// progress, and hands over the results. Main thread.
#pragma once

#include "core/engine/headless/run_task.h"
#include "core/vehicle/vehicle_state.h"

#include <string>
#include <string_view>

namespace skyseal::app {

struct TaskSettings
{
    std::uint8_t systemId = 0;                      ///< 0: the only vehicle
    Duration findWithin = std::chrono::seconds(30); ///< then the command gives up
    bool json = false;
};

class VehicleTask : public engine::RunTask
{
public:
    /// Without --sysid, for so long after the first vehicle others may come.
    static constexpr Duration kOthers = std::chrono::milliseconds(1500);

    explicit VehicleTask(const TaskSettings &settings) : m_settings(settings) {}

    void advance(TimePoint now, const engine::Snapshot &snapshot) final;
    void handle(const engine::Event &event) final;
    std::optional<engine::TaskRequest> pollRequest() final { return std::exchange(m_next, std::nullopt); }
    void requestSent(vehicle::RequestId id) final { m_current = id; }
    bool isFinished() const final { return m_finished; }
    const std::string &problem() const final { return m_problem; }
    bool isFileProblem() const final { return m_isFileProblem; }

protected:
    /// Called once, when the vehicle is known: makes the first request.
    virtual void start(const vehicle::VehicleState &vehicle) = 0;
    /// The result of the request in progress: makes the next request, or finishes.
    virtual void parameterEnded(const vehicle::ParameterResult &) {}
    virtual void planEnded(const vehicle::MissionResult &) {}
    virtual void fileEnded(const vehicle::FileResult &) {}
    virtual void logEnded(const vehicle::LogResult &) {}

    void ask(vehicle::Request request) { m_next = {m_systemId, std::move(request)}; }
    void finish(std::string problem = {});
    /// `problem`: of the file that takes the result; empty if it was saved, or if there is none.
    void finishSaved(std::string problem);
    bool isJson() const { return m_settings.json; }
    std::uint8_t systemId() const { return m_systemId; }

private:
    void dispatch(const vehicle::ParameterResult &result) { parameterEnded(result); }
    void dispatch(const vehicle::MissionResult &result) { planEnded(result); }
    void dispatch(const vehicle::FileResult &result) { fileEnded(result); }
    void dispatch(const vehicle::LogResult &result) { logEnded(result); }
    void find(TimePoint now, const engine::Snapshot &snapshot);
    void showProgress(TimePoint now, const engine::Snapshot &snapshot);

    const TaskSettings m_settings;
    std::optional<TimePoint> m_begun, m_firstFound;
    TimePoint m_shown = TimePoint::min();
    std::uint64_t m_shownDone = 0;
    std::uint8_t m_systemId = 0; ///< 0 before the vehicle is known
    std::optional<engine::TaskRequest> m_next;
    vehicle::RequestId m_current{};
    bool m_finished = false;
    std::string m_problem;
    bool m_isFileProblem = false;
};

} // namespace skyseal::app
