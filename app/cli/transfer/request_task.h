// A task of one request to a vehicle.
#pragma once

#include "app/cli/transfer/vehicle_task.h"

#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace skyseal::app {

/// Hands a result of success to a function that returns what went wrong with it, or an empty text. `Result`:
/// vehicle::MissionResult, FileResult or LogResult.
template<typename Result> class RequestTask final : public VehicleTask
{
public:
    using Take = std::function<std::string(const Result &)>;

    /// `subject`: what a failure is about, "/APM/LOGS: "; may be empty.
    RequestTask(const TaskSettings &settings, vehicle::Request request, Take take, std::string subject = {})
        : VehicleTask(settings), m_request(std::move(request)), m_take(std::move(take)), m_subject(std::move(subject))
    {}

protected:
    void start(const vehicle::VehicleState &) override { ask(std::move(m_request)); }
    void planEnded(const vehicle::MissionResult &result) override { end(result); }
    void fileEnded(const vehicle::FileResult &result) override { end(result); }
    void logEnded(const vehicle::LogResult &result) override { end(result); }

private:
    template<typename Other> void end(const Other &result)
    {
        if constexpr (std::is_same_v<Other, Result>)
            result.ok ? finishSaved(m_take(result)) : finish(m_subject + result.reason.text());
    }

    vehicle::Request m_request;
    Take m_take;
    const std::string m_subject;
};

} // namespace skyseal::app
